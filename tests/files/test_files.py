"""Files are absent, old, or whole; never half."""

import errno
import hashlib
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
from pathlib import Path

import pytest

from firebreak_gis import files
from firebreak_gis.errors import FirebreakError, InputError, OutputError, VerificationError


def names(folder):
    return sorted(entry.name for entry in folder.iterdir())


def put(target, text="new", **more):
    with files.replacing(target, **more) as part:
        part.write_text(text)
    return target


def test_a_new_file_appears_whole_and_alone(tmp_path):
    target = tmp_path / "out.txt"
    with files.replacing(target) as part:
        part.write_text("new")
        assert part.parent == tmp_path
        assert part.suffix == ".txt"
        assert not target.exists()
    assert target.read_text() == "new"
    assert names(tmp_path) == ["out.txt"]


def test_an_existing_file_is_only_replaced_when_asked(tmp_path):
    target = put(tmp_path / "out.txt", "old")
    with pytest.raises(OutputError, match="overwrite"):
        put(target)
    assert target.read_text() == "old"
    assert put(target, overwrite=True).read_text() == "new"


@pytest.mark.parametrize(
    "stop", [KeyboardInterrupt, ValueError("wrong"), OSError(errno.EIO, "broken disk"), SystemExit]
)
def test_any_exception_leaves_the_old_file_and_nothing_else(tmp_path, stop):
    target = put(tmp_path / "out.txt", "old")
    expected = OutputError if isinstance(stop, OSError) else stop if isinstance(stop, type) else type(stop)

    def write_half():
        with files.replacing(target, overwrite=True) as part:
            part.write_text("half")
            part.with_name(part.name + "-journal").write_text("left by a driver")
            raise stop

    with pytest.raises(expected):
        write_half()
    assert target.read_text() == "old"
    assert names(tmp_path) == ["out.txt"]


def test_a_failed_verification_leaves_nothing(tmp_path):
    def verify(part):
        assert part.read_text() == "new"
        raise VerificationError("not right")

    with pytest.raises(VerificationError):
        put(tmp_path / "out.txt", verify=verify)
    assert names(tmp_path) == []


def test_writing_nothing_is_an_error(tmp_path):
    with pytest.raises(OutputError, match="nothing was written"), files.replacing(tmp_path / "out.txt"):
        pass
    assert names(tmp_path) == []


def _fail_at(monkeypatch, wanted, code):
    """Let the wanted-th system call of a write fail; return how many were made."""
    made = []

    def wrap(holder, name):
        genuine = getattr(holder, name)

        def call(*args, **kwargs):
            made.append(name)
            if len(made) == wanted:
                raise OSError(code, os.strerror(code))
            return genuine(*args, **kwargs)

        monkeypatch.setattr(holder, name, call)

    for holder, name in (
        (files.os, "open"),
        (files.os, "fsync"),
        (files.Path, "replace"),
        (files.Path, "open"),
    ):
        wrap(holder, name)
    return made


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EACCES, errno.EIO])
@pytest.mark.parametrize("overwrite", [False, True])
def test_a_fault_at_any_call_leaves_absent_old_or_whole(tmp_path, monkeypatch, code, overwrite):
    wanted = 0
    while True:
        wanted += 1
        folder = tmp_path / f"{wanted}"
        folder.mkdir()
        target = folder / "out.txt"
        if overwrite:
            target.write_text("old")
        with monkeypatch.context() as patch:
            made = _fail_at(patch, wanted, code)
            failed = False
            try:
                put(target, overwrite=overwrite)
            except OutputError:
                failed = True
        assert set(names(folder)) <= {"out.txt"}
        if target.exists():
            assert target.read_text() in ("old", "new")
        elif overwrite:
            pytest.fail("the old file is gone")
        if len(made) < wanted:
            assert not failed
            break
    assert wanted > 4


def test_the_disk_full_message_says_so(tmp_path):
    with pytest.raises(OutputError, match="disk is full"), files.replacing(tmp_path / "a.tif"):
        raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize("link", ["same", "symbolic", "hard", "relative"])
def test_an_input_is_never_the_target(tmp_path, link, monkeypatch):
    source = tmp_path / "in.tif"
    source.write_text("precious")
    target = source
    if link == "symbolic":
        target = tmp_path / "link.tif"
        target.symlink_to(source)
    elif link == "hard":
        target = tmp_path / "hard.tif"
        target.hardlink_to(source)
    elif link == "relative":
        monkeypatch.chdir(tmp_path)
        target = Path("in.tif")
    with pytest.raises(OutputError, match="is the input"):
        put(target, overwrite=True, forbid=[source])
    assert source.read_text() == "precious"


def test_a_link_is_followed(tmp_path):
    target = tmp_path / "deep" / "out.txt"
    target.parent.mkdir()
    target.write_text("old")
    link = tmp_path / "link.txt"
    link.symlink_to(target)
    put(link, overwrite=True)
    assert link.is_symlink()
    assert target.read_text() == "new"


@pytest.mark.parametrize(
    ("make", "match"),
    [
        (lambda folder: folder / "missing" / "out.txt", "does not exist"),
        (lambda folder: folder, "is a folder"),
        (lambda folder: Path("/proc/out.txt"), "cannot write"),
        (lambda folder: folder / ("x" * 300), "cannot write|too long"),
    ],
)
def test_impossible_targets_are_refused_up_front(tmp_path, make, match):
    if not Path("/proc/self").exists():
        pytest.skip("needs /proc")
    with pytest.raises(OutputError, match=match):
        files.require_writable(make(tmp_path))
    assert names(tmp_path) == []


def test_the_longest_name_works(tmp_path):
    target = put(tmp_path / ("ü" * 120 + ".txt"))
    assert target.read_text() == "new"


def test_a_write_protected_file_stays(tmp_path):
    target = put(tmp_path / "out.txt", "old")
    target.chmod(0o400)
    if os.access(target, os.W_OK):
        _refused_to_nobody()
        return
    with pytest.raises(OutputError, match="protected"):
        put(target, overwrite=True)
    assert target.read_text() == "old"


def _refused_to_nobody(nobody=65534):
    """The administrator may write everything: let a child that has given up its rights try."""
    with tempfile.TemporaryDirectory() as name:
        target = put(Path(name) / "out.txt", "old")
        target.chmod(0o400)
        os.chown(target, nobody, nobody)
        os.chown(name, nobody, nobody)
        child = os.fork()
        if child == 0:
            code = 1
            try:
                os.setgroups([])
                os.setgid(nobody)
                os.setuid(nobody)
                put(target.with_name("other.txt"))
                code = 2  # the folder can be written, so what follows is for the file's protection
                put(target, overwrite=True)
            except OutputError as error:
                code = 0 if code == 2 and "protected" in str(error) else 3
            finally:
                os._exit(code)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
        assert target.read_text() == "old"
        assert names(Path(name)) == ["other.txt", "out.txt"]


def test_a_second_writer_is_refused(tmp_path):
    target = tmp_path / "out.txt"
    with files.replacing(target) as part:
        part.write_text("first")
        with pytest.raises(OutputError, match="another run"):
            put(target, "second")
        put(tmp_path / "other.txt")
    assert target.read_text() == "first"
    assert names(tmp_path) == ["other.txt", "out.txt"]


CHILD = textwrap.dedent(
    """
    import sys, time
    from firebreak_gis.files import replacing
    with replacing(sys.argv[1], overwrite=True) as part:
        part.write_text("half")
        print("writing", flush=True)
        time.sleep(60)
    """
)


def _start(target):
    root = Path(files.__file__).parents[1]
    child = subprocess.Popen([sys.executable, "-c", CHILD, str(target)], stdout=subprocess.PIPE, cwd=root)
    assert child.stdout.readline().strip() == b"writing"
    return child


def test_a_killed_writer_blocks_nobody_and_its_rest_is_removed(tmp_path):
    target = put(tmp_path / "out.txt", "old")
    child = _start(target)
    with child.stdout:
        with pytest.raises(OutputError, match="another run"):
            put(target, overwrite=True)
        child.kill()
        child.wait()
    assert target.read_text() == "old"
    assert len(names(tmp_path)) == 3  # what a kill leaves: its part and its lock file
    put(tmp_path / "other.txt")
    assert names(tmp_path) == ["other.txt", "out.txt"]
    assert put(target, overwrite=True).read_text() == "new"


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to a single process there")
def test_an_interrupt_from_outside_leaves_nothing(tmp_path):
    target = tmp_path / "out.txt"
    child = _start(target)
    with child.stdout:
        child.send_signal(signal.SIGINT)
        start = time.monotonic()
        assert child.wait() != 0
        assert time.monotonic() - start < 5
    assert names(tmp_path) == []


def test_a_live_writers_part_is_not_stale(tmp_path):
    with files.replacing(tmp_path / "one.txt") as part:
        part.write_text("one")
        put(tmp_path / "two.txt")
        assert part.read_text() == "one"


def test_a_strangers_file_is_not_touched(tmp_path):
    stranger = tmp_path / ".firebreak-notes"
    stranger.write_text("mine")
    put(tmp_path / "out.txt")
    assert stranger.read_text() == "mine"


def test_sha256(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"abc" * 100_000)
    assert files.sha256(path) == hashlib.sha256(b"abc" * 100_000).hexdigest()
    with pytest.raises(InputError, match="cannot read"):
        files.sha256(tmp_path / "missing")


def test_make_folder_refuses_a_file_in_the_way(tmp_path):
    assert files.make_folder(tmp_path / "a" / "b").is_dir()
    (tmp_path / "c").write_text("")
    with pytest.raises(OutputError):
        files.make_folder(tmp_path / "c" / "d")


def test_errors_stand_under_the_root():
    assert issubclass(OutputError, FirebreakError)
    assert issubclass(OutputError, OSError)
