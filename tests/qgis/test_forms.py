"""What the forms look like: lists to read, texts in the language of QGIS, the help page, what the engine says."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
)
from qgis.PyQt.QtCore import QCoreApplication, Qt
from qgis.PyQt.QtWidgets import QComboBox, QDialog, QListWidget

pytestmark = pytest.mark.usefixtures("provider")


def form(name: str):
    return QgsApplication.processingRegistry().createAlgorithmById(f"firebreak:{name}")


def wrapper(algorithm, parameter: str, dialog: object):
    from processing.gui.wrappers import WidgetWrapperFactory

    return WidgetWrapperFactory.create_wrapper(algorithm.parameterDefinition(parameter), dialog)


class BatchAlgorithmDialog:
    """Its name is what the wrappers look at."""


class ModelerParametersDialog(QDialog):
    """Likewise; with what the modeler's dialog has."""

    def __init__(self, model, child):
        super().__init__()
        self.model, self.childId, self.context = model, child, QgsProcessingContext()


@pytest.mark.parametrize("dialog", [object, BatchAlgorithmDialog])
def test_a_list_shows_words_and_gives_the_engines(dialog):
    plan = form("plan")
    made = wrapper(plan, "METHOD", dialog())
    combo = made.widget
    assert isinstance(combo, QComboBox)
    assert made.parameterValue() == plan.parameterDefinition("METHOD").defaultValue()
    texts = [combo.itemText(i) for i in range(combo.count())]
    assert any(text.startswith("Dissection: walls between compartments") for text in texts)
    assert "dissection" not in texts
    told = []
    made.widgetValueHasChanged.connect(told.append)
    combo.setCurrentIndex(next(i for i, text in enumerate(texts) if text.startswith("Betweenness centrality")))
    assert made.parameterValue() == "betweenness"
    assert told
    made.setParameterValue("degree", QgsProcessingContext())
    assert combo.currentText().startswith("Degree: ")
    assert plan.parameterDefinition("METHOD").checkValueIsAcceptable(made.parameterValue())


def test_a_list_of_an_optional_parameter_may_be_left_empty():
    plan = form("plan")  # a widget does not keep its algorithm alive, and falls with it
    made = wrapper(plan, "DENSITY", object())
    assert made.parameterValue() is None
    assert made.widget.itemText(0) == "[not chosen]"
    made.widget.setCurrentIndex(1)
    assert made.parameterValue() == "sparse"


def test_several_choices_are_ticked():
    compare = form("compare")
    made = wrapper(compare, "METHODS", object())
    assert isinstance(made.widget, QListWidget)
    default = compare.parameterDefinition("METHODS").defaultValue()
    assert made.parameterValue() == [m for m in compare.parameterDefinition("METHODS").options() if m in default] != []
    made.setParameterValue("random,degree", QgsProcessingContext())
    assert made.parameterValue() == ["degree", "random"]
    for row in range(made.widget.count()):
        made.widget.item(row).setCheckState(Qt.CheckState.Unchecked)
    assert made.parameterValue() == []


def test_dialogs_of_qgis_give_the_engines_words(monkeypatch):
    """The real dialogs: the form as it opens, one choice changed, and a row of a batch."""
    from processing.gui import AlgorithmDialogBase, BatchPanel, ParametersPanel
    from processing.gui.AlgorithmDialog import AlgorithmDialog
    from processing.gui.BatchAlgorithmDialog import BatchAlgorithmDialog

    for module in (AlgorithmDialogBase, BatchPanel, ParametersPanel):  # there is no window here to be part of
        monkeypatch.setattr(module, "iface", None, raising=False)
    dialog = AlgorithmDialog(form("plan"), False, None)
    combo = next(c for c in dialog.findChildren(QComboBox) if c.findData("betweenness") >= 0)
    combo.setCurrentIndex(combo.findData("betweenness"))
    wrappers = dialog.mainWidget().wrappers
    assert wrappers["METHOD"].parameterValue() == "betweenness"
    assert wrappers["LEGEND"].parameterValue() == "paper"
    batch = BatchAlgorithmDialog(form("compare"), None)
    (row,) = batch.mainWidget().wrappers[:1]
    (methods,) = [w for w in row if w is not None and w.parameterDefinition().name() == "METHODS"]
    assert "bonacich" in methods.parameterValue()


def test_the_modeler_keeps_its_own_widget_with_words_in_the_list():
    model = QgsProcessingModelAlgorithm()
    child = model.addChildAlgorithm(QgsProcessingModelChildAlgorithm("firebreak:plan"))
    plan, dialog = form("plan"), ModelerParametersDialog(model, child)
    made = wrapper(plan, "METHOD", dialog)
    texts = {c.itemText(i): c.itemData(i) for c in made.findChildren(QComboBox) for i in range(c.count())}
    (word,) = [text for text, value in texts.items() if value == "dissection"]
    assert word.startswith("Dissection: walls")
    made.setWidgetValue([])


def test_every_list_of_every_form_can_be_made(provider):
    seen = 0
    for algorithm in provider.algorithms():
        own = form(algorithm.name())
        for definition in own.parameterDefinitions():
            if definition.type() == "enum":
                made = wrapper(own, definition.name(), object())
                assert made.widget.count() >= len(definition.options())
                seen += 1
    assert seen > 30


@pytest.mark.parametrize(
    ("locale", "title"), [("de", "Brandschneisen planen"), ("pt_BR", "Planear aceiros"), ("xx", "Plan fire breaks")]
)
def test_forms_speak_the_language_of_qgis(locale, title, monkeypatch):
    from firebreak import translation
    from firebreak.provider import FirebreakProvider

    monkeypatch.setattr(QgsApplication, "locale", staticmethod(lambda: locale))
    try:
        other = FirebreakProvider()
        other.loadAlgorithms()
        (plan,) = [a for a in other.algorithms() if a.name() == "plan"]
        assert title in plan.displayName()
        assert (plan.parameterDefinition("METHOD").description() == "Ranking") == (locale == "xx")
        assert plan.parameterDefinition("METHOD").options() == form("plan").parameterDefinition("METHOD").options()
        assert title in plan.displayName()
    finally:
        translation.use("en")


def test_the_help_opens_the_documentation_of_a_release(monkeypatch):
    from firebreak import texts

    monkeypatch.setattr(texts, "documentation", lambda: "https://forest.net/docs")
    assert form("rank").helpUrl() == "https://forest.net/docs/generated/commands.html#firebreak-rank"


def test_what_the_engine_says_is_shown_while_it_works(monkeypatch, layers, tmp_path):
    """Such as how long it will take: before the first step, in the log."""
    from firebreak.engine import lookup

    engine = tmp_path / "firebreak"
    script = (
        "import json, sys\n"
        "def say(**d): print(json.dumps(d), flush=True)\n"
        "if '--version' in sys.argv: say(software='firebreak_gis', version='9.9.9'); sys.exit()\n"
        "say(said='about 3 min; less with a smaller --runs')\n"
        "say(warning='a small map')\n"
        "say(error={'kind': 'input', 'message': 'enough', 'exit_code': 3}); sys.exit(3)\n"
    )
    engine.write_text(f"#!{sys.executable}\n{script}")
    engine.chmod(0o755)
    monkeypatch.setenv("FIREBREAK_PYTHON", str(engine))
    lookup.forget()
    feedback = QgsProcessingFeedback(False)
    try:
        plan, context = form("plan"), QgsProcessingContext()
        plan.run({**layers, "OUTPUT_BREAKS": str(tmp_path / "b.tif")}, context, feedback)
    finally:
        lookup.forget()
    log = feedback.textLog()
    assert 'about 3 min; less with a smaller "Number of fires"' in log
    assert log.index("about 3 min") < log.index("a small map")


def test_the_engine_tells_what_it_did_to_the_layers(layers, tmp_path):
    assert Path(os.environ["FIREBREAK_PYTHON"]).exists()
    feedback = QgsProcessingFeedback(False)
    outputs = {"OUTPUT_ELEVATION": str(tmp_path / "e.tif")}
    _, ok = form("align").run({**layers, "RESOLUTION": 90, **outputs}, QgsProcessingContext(), feedback)
    QCoreApplication.processEvents()
    assert ok
    assert feedback.textLog().count("resampled") >= 1
