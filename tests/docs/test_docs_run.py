"""Every block of code in the documentation runs as it stands there, or says why it does not."""

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = sorted(p for p in DOCS.rglob("*.md") if not {"_build", "generated"} & set(p.relative_to(DOCS).parts))
FENCE = re.compile(r"((?:^<!-- [^\n]* -->\n)*)^```(\S*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
#: Blocks that tests/contracts/test_readme.py runs, and looks at what comes out.
RUN_BY_MARK = {"commands", "clock", "stakes", "python", "main job", "test"}


def blocks(page):
    """Language and text of every block to run, in order."""
    for comments, language, text in FENCE.findall(page.read_text(encoding="utf-8")):
        marks = re.findall(r"<!-- (.*?) -->", comments)
        reasons = [m.removeprefix("not run: ") for m in marks if m.startswith("not run: ")]
        if language in ("bash", "python", "sh") and not reasons and not RUN_BY_MARK & set(marks):
            yield language, text


def run(language, text, scope, name):
    if language == "python":
        exec(compile(text, name, "exec"), scope)
        return
    for line in filter(None, text.splitlines()):
        words = shlex.split(line, comments=True)
        if words[0] == "cmp":
            assert Path(words[1]).read_bytes() == Path(words[2]).read_bytes(), line
            continue
        assert words[0] == "firebreak", f"{line}: only firebreak runs here; mark the block <!-- not run: why -->"
        outcome = CliRunner().invoke(firebreak, words[1:])
        assert outcome.exit_code == 0, f"{line}\n{outcome.output}\n{outcome.exception}"


WITH_CODE = [page for page in PAGES if any(blocks(page))]


@pytest.mark.parametrize("page", WITH_CODE, ids=lambda page: str(page.relative_to(DOCS)))
def test_blocks_run(page, tmp_path, monkeypatch):
    (tmp_path / "sample_data").symlink_to(ROOT / "sample_data")
    monkeypatch.chdir(tmp_path)
    scope = {}
    for language, text in blocks(page):
        run(language, text, scope, page.name)
    assert [p for p in tmp_path.rglob("*") if p.is_file()] or scope or "legends" in page.read_text(encoding="utf-8")


def test_blocks_are_found():
    assert {"tutorial.md", "own-fire-model.md", "crews.md"} <= {page.name for page in WITH_CODE}
    assert sum(len(list(blocks(page))) for page in PAGES) >= 12


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(DOCS)))
def test_no_code_hides_from_the_tests(page):
    """A command that is indented, or in a block without a language, would run nowhere."""
    text = page.read_text(encoding="utf-8")
    for _, language, block in FENCE.findall(text):
        if language in ("", "text", "console", "shell"):
            assert not re.search(r"^\$? ?firebreak \w", block, re.MULTILINE), block
    assert not re.search(r"^    (firebreak|python) ", FENCE.sub("", text), re.MULTILINE)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(DOCS)))
def test_files_that_a_page_links_to_exist(page):
    for path in re.findall(r"\]\(((?!http)[^)#\s]+)", page.read_text(encoding="utf-8")):
        assert path.split("/")[-2:-1] == ["generated"] or (page.parent / path).exists(), path


def test_options_that_pages_name_exist():
    """Options in running text, too: a renamed one must not live on in a page."""
    known = {flag for line in _flags(firebreak) for flag in line}
    foreign = {"--extra", "--only", "--huge", "--no-skips", "--output", "--lengths", "--lines", "--strengths"}
    foreign |= {"--rhodes", "--seconds"}  # tests.benchmarks.yardstick
    foreign |= {"--port", "--nworkers", "--nthreads", "--scheduler-file", "--ntasks", "--cpus-per-task"}  # dask, Slurm
    for page in PAGES:
        prose = re.sub(r"<!--.*?-->|--\w+-->", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+[a-z]", prose)) - foreign
        assert named <= known, f"{page.name}: {sorted(named - known)}"


def _flags(command):
    yield {flag for p in command.params for flag in (*p.opts, *p.secondary_opts)} | {"--help", "--version"}
    for inner in getattr(command, "commands", {}).values():
        yield from _flags(inner)
    if hasattr(command, "list_commands") and not getattr(command, "commands", {}):
        import click

        ctx = click.Context(command)
        for name in command.list_commands(ctx):
            yield from _flags(command.get_command(ctx, name))


def test_a_mark_names_one_block():
    """Of two blocks with the same mark the second would run nowhere."""
    marks = []
    for page in [ROOT / "README.md", *PAGES]:
        for comments, _, _ in FENCE.findall(page.read_text(encoding="utf-8")):
            marks += [m for m in re.findall(r"<!-- (.*?) -->", comments) if m in RUN_BY_MARK]
    assert sorted(marks) == sorted(RUN_BY_MARK)
