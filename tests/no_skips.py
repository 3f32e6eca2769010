"""`pytest --no-skips`: a run in which a test was skipped fails, since what is skipped is not tested.

A test that may be skipped all the same, because no machine can be asked for what it needs, says so:
`@pytest.mark.may_skip("why")`.
"""

from __future__ import annotations

import pytest

OPTION = "--no-skips"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option."""
    parser.addoption(OPTION, action="store_true", help="Fail if a test is skipped that does not say that it may be.")


def pytest_configure(config: pytest.Config) -> None:
    """Declare the mark, and watch where it is asked for; workers leave that to the process that started them."""
    config.addinivalue_line("markers", "may_skip(why): the test may be skipped although --no-skips is given")
    if config.getoption(OPTION) and not hasattr(config, "workerinput"):
        config.pluginmanager.register(_Watch())


class _Watch:
    """Collects what was skipped; fails the run if that is anything."""

    def __init__(self) -> None:
        self.skipped: list[str] = []

    def _note(self, report: pytest.TestReport | pytest.CollectReport) -> None:
        why = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        self.skipped.append(f"{report.nodeid}: {why}")

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """A test was skipped (and not only expected to fail)."""
        if report.skipped and not hasattr(report, "wasxfail") and "may_skip" not in report.keywords:
            self._note(report)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """A whole file was skipped."""
        if report.skipped:
            self._note(report)

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Turn success into failure."""
        if self.skipped and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """Say which."""
        if self.skipped:
            terminalreporter.section(f"skipped, which {OPTION} forbids", red=True)
            for line in sorted(self.skipped):
                terminalreporter.write_line(line)
