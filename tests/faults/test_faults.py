"""Disks that fill, fail or refuse at any call: old files or whole new ones, exit code 4, nothing in between."""

import ast
import errno
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

import firebreak_gis
from firebreak_gis import files
from firebreak_gis.errors import OutputError
from tests.faults import writers
from tests.faults.state import content, left_over, put_back

ROOT = Path(__file__).parents[2]
SHIM = Path(__file__).with_name("shim.c")


@pytest.fixture
def quick_folder(tmp_path):
    """Folder in memory where there is one: thousands of flushes to a disk take their time."""
    memory = Path("/dev/shm")
    if not os.access(memory, os.W_OK):
        yield tmp_path
        return
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        yield Path(folder)


@pytest.fixture(scope="module")
def shim(tmp_path_factory):
    """Library that lets a chosen call of the C library fail."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if sys.platform != "linux" or compiler is None:
        pytest.skip("needs Linux and a C compiler")
    library = tmp_path_factory.mktemp("shim") / "shim.so"
    subprocess.run([compiler, "-shared", "-fPIC", "-O1", "-Wall", "-o", library, SHIM, "-ldl"], check=True)
    return library


@pytest.mark.parametrize("kind", writers.KINDS[::-1])
def test_every_call_may_fail_or_be_the_last(kind, shim, quick_folder):
    environment = {**os.environ, "LD_PRELOAD": str(shim), "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-m", "tests.faults.sweep", kind, quick_folder],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        text=True,
        timeout=400,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    found = json.loads(done.stdout)
    assert found["findings"] == []
    assert min(found["calls"]) > 8  # the faults were met at all


def _refused(kind, folder):
    """Write variant 1; return the error, None if there was none."""
    try:
        writers.write(kind, folder, 1, overwrite=True)
    except OutputError as error:
        return error
    return None


@pytest.mark.skipif(sys.platform == "win32", reason="no limits on the size of files there")
@pytest.mark.parametrize("kind", [kind for kind in writers.KINDS if kind != "zip"])  # its pieces are larger than it
def test_a_limit_on_the_size_of_files_leaves_all_as_it_was(kind, quick_folder):
    import resource

    folder = quick_folder
    old, new = writers.contents(kind, folder)
    largest = max(len(data) for data in new.values())
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    refused = 0
    for limit in [0, 1, *range(511, largest, max(largest // 12, 1)), largest - 1, largest]:
        put_back(folder, old)
        # Python ignores the signal that goes with it, so writing beyond the limit is an error.
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, hard))
        error = _refused(kind, folder)
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        assert (error is None) == (limit == largest)
        if error is not None:
            refused += 1
            assert error.exit_code == 4
            assert "larger than" in str(error) or "is the disk full?" in str(error)
        assert content(folder) == (new if error is None else old)
        assert left_over(folder) == []
    assert refused >= 3


@pytest.fixture
def small_disk(tmp_path):
    """Mount point of a disk of 512 KB."""
    mounted = shutil.which("mount") and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=512k", "firebreak", tmp_path], capture_output=True
    )
    if not mounted or mounted.returncode != 0:
        pytest.skip("mounting a small disk is not allowed here")
    yield tmp_path
    subprocess.run(["umount", tmp_path], check=True)


@pytest.mark.may_skip("a container may not mount a disk")
def test_a_disk_that_is_full_at_any_page(small_disk):
    ballast, folder = small_disk / "ballast", small_disk / "out"
    folder.mkdir()
    old, new = writers.contents("landscape", folder)
    page, filled = 4096, 0
    while True:
        put_back(folder, old)
        room = shutil.disk_usage(small_disk).free - filled * page
        if room < 0:
            break
        ballast.write_bytes(b"x" * room)
        error = _refused("landscape", folder)
        ballast.unlink()
        assert content(folder) == (new if error is None else old)
        if error is None:
            break
        assert "disk is full" in str(error)
        assert left_over(folder) == []
        filled += 1
    assert filled > 5
    assert content(folder) == new


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EACCES, errno.EIO, errno.EROFS, errno.EDQUOT])
def test_a_refusal_says_why_and_what_to_do(tmp_path, monkeypatch, code):
    target = tmp_path / "out.csv"
    target.write_text("old")

    def refuse(*_):
        raise OSError(code, os.strerror(code))

    with monkeypatch.context() as patch:
        patch.setattr(files.os, "fsync", refuse)
        with pytest.raises(OutputError) as caught:
            files.write_text(target, "new", overwrite=True)
    assert caught.value.exit_code == 4
    assert "out.csv" in str(caught.value)
    assert len(str(caught.value).split(": ")[-1]) > 10
    assert target.read_text() == "old"


WRITING = {"write_text", "write_bytes", "unlink", "rmdir", "touch", "rename", "hardlink_to", "symlink_to"}
#: Where it is a column or a variable that gets another name.
RENAMED = {"comparison", "grid", "plan", "shapefile", "siting"}
#: Where GDAL writes a file by itself, which is read back before it takes its place.
BY_GDAL = {"blocks"}
IN_MEMORY = {("vectors", "to_file"), ("vectors", "to_parquet"), ("figures", "savefig"), ("__init__", "savefig")}


def _calls(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            yield name, isinstance(node.func, ast.Name), node


def test_there_is_one_writer():
    """No other module opens a file for writing, moves or removes one."""
    package = Path(firebreak_gis.__file__).parent
    for path in package.rglob("*.py"):
        if path.parent.name == "files":
            continue
        for name, plain, node in _calls(path):
            where = f"{path.relative_to(package)}, line {node.lineno}: {name}"
            if plain:
                assert name != "open", where
                continue
            assert name not in WRITING or (name == "rename" and path.stem in RENAMED), where
            if name in ("to_file", "to_parquet", "savefig", "to_raster", "tofile"):
                assert (path.stem, name) in IN_MEMORY or not node.args, where
            if name == "open" and path.stem not in BY_GDAL:
                modes = [a.value for a in node.args if isinstance(a, ast.Constant) and isinstance(a.value, str)]
                assert not [m for m in modes if set(m) & set("wax+")], where
