"""The one algorithm class: a form built from the manifest, a run of the engine, files put in place."""

from __future__ import annotations

import shutil
import tempfile
from datetime import datetime
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingUtils,
)
from qgis.PyQt.QtGui import QIcon

from . import settings
from .arguments import ArgumentsError, command_arguments
from .engine.errors import EngineCancelledError, EngineError, EngineMissingError
from .engine.lookup import Engine
from .engine.process import Listener, run
from .formats import deliver_vector
from .forms import GROUPS
from .layers import FormValues
from .manifest import Description, Output, parameter_names
from .parameters import input_parameter, output_parameter
from .results import DestinationError, deliver, deliver_folder, refuse_formats, refuse_inputs
from .styling import Run, style_later
from .texts import field_label, help_address, help_page, translated
from .translation import translate
from .words import in_form_words

_ICONS = Path(__file__).with_name("icons")


class FirebreakAlgorithm(QgsProcessingAlgorithm):
    """Runs one command of firebreak_gis on layers of QGIS.

    Parameters
    ----------
    description
        From `manifest.descriptions`.
    """

    def __init__(self, description: Description) -> None:
        super().__init__()
        self._description = description

    def createInstance(self) -> FirebreakAlgorithm:  # noqa: N802 - this and the following are named by QGIS
        """Return a fresh copy."""
        return FirebreakAlgorithm(self._description)

    def name(self) -> str:
        """Return the identifier."""
        return self._description.form.name

    def displayName(self) -> str:  # noqa: N802
        """Return the title."""
        return translated(self._description.form.title)

    def group(self) -> str:
        """Return the title of the group."""
        return translated(GROUPS[self._description.form.group])

    def groupId(self) -> str:  # noqa: N802
        """Return the identifier of the group."""
        return self._description.form.group

    def tags(self) -> list[str]:
        """Return words to be found by."""
        return ["fire", "firebreak", *self._description.form.tags]

    def icon(self) -> QIcon:
        """Return the picture in the toolbox."""
        return QIcon(str(_ICONS / f"{self.name()}.svg"))

    def svgIconPath(self) -> str:  # noqa: N802
        """Return the path of the picture."""
        return str(_ICONS / f"{self.name()}.svg")

    def shortHelpString(self) -> str:  # noqa: N802
        """Return the help page."""
        return help_page(self._description)

    def shortDescription(self) -> str:  # noqa: N802
        """Return the help in a line."""
        return translated(self._description.text.split("\n\n", 1)[0])

    def helpUrl(self) -> str:  # noqa: N802
        """Return the address of the documentation."""
        return help_address(self.name())

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:  # noqa: N802, ARG002
        """Build the form."""
        for field in self._description.fields:
            self.addParameter(input_parameter(field))
        for output in self._description.outputs:
            self.addParameter(output_parameter(output))
        for key, text in self._description.form.numbers.items():
            self.addOutput(QgsProcessingOutputNumber(key.upper(), translated(text)))

    def canExecute(self) -> tuple[bool, str]:  # noqa: N802
        """Tell whether there is an engine, and if not what to do."""
        try:
            settings.current_engine()
        except EngineMissingError as error:
            return False, str(error)
        return True, ""

    def processAlgorithm(  # noqa: N802
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        """Run the engine and put its files in place."""
        try:
            return self._process(parameters, context, feedback)
        except EngineCancelledError:
            feedback.pushInfo(translate("Firebreak", "Stopped; no output was written."))
            return {}
        except (EngineError, ArgumentsError, DestinationError, QgsProcessingException) as error:
            failure = in_form_words(str(error))
        # QGIS keeps an exception that leaves this method for good, and with it every layer that its frames hold:
        # files would stay open, and QGIS crash at exit. So it gets a new one, and these names are given up.
        del parameters, context, feedback
        raise QgsProcessingException(failure)

    def _process(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        """Work in a temporary folder."""
        folder = Path(tempfile.mkdtemp(prefix="firebreak-", dir=QgsProcessingUtils.tempFolder()))
        try:
            engine = settings.current_engine()  # not every release of QGIS asks `canExecute`
            feedback.pushInfo(f"firebreak_gis {engine.version} ({engine.origin})")
            wanted = self._destinations(parameters, context)
            values = FormValues(self, parameters, context, feedback, folder).read(self._description.fields)
            layers = [str(values[f.name]) for f in self._description.fields if f.kind in ("raster", "vector", "file")]
            files = {o.name: o.file_for(wanted.get(o.name, "")) for o in self._description.outputs}
            refuse_formats(wanted, files)
            refuse_inputs(wanted, [path for path in layers if path != "None"])
            result = self._run(engine, values, wanted, folder, feedback)
            run_of = self._run_of(engine, values, folder.name)
            return self._deliver(result, wanted, folder / "out", run_of, context, feedback)
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def _destinations(self, parameters: dict[str, Any], context: QgsProcessingContext) -> dict[str, str]:
        """Return the path of every output that is wanted, by parameter name."""
        found = {}
        for output in self._description.outputs:
            is_layer = output.kind in ("raster", "vector")
            read = self.parameterAsOutputLayer if is_layer else self.parameterAsFileOutput
            path = read(parameters, output.name, context)
            if path:
                found[output.name] = path
        return found

    def _run(
        self,
        engine: Engine,
        values: dict[str, Any],
        wanted: dict[str, str],
        folder: Path,
        feedback: QgsProcessingFeedback,
    ) -> dict[str, Any]:
        form, fields, target = self._description.form, self._description.fields, folder / "out"
        target.mkdir()
        main = self._main_output()
        file = main.file_for(wanted.get(main.name, ""))
        extra = {"-o": str(target if self._description.into_folder else target / file)}
        for output in self._description.outputs:
            if output.flag and output.name in wanted:
                extra[output.flag] = str(target / output.file)
        runs = []
        if form.before is not None:
            aligned = str(folder / form.before)
            names = parameter_names(form.before)
            runs.append(command_arguments(form.before, names, fields, values, {"-o": aligned}))
            extra[""] = aligned
        runs.append(command_arguments(form.name, parameter_names(form.name), fields, values, extra))
        result: dict[str, Any] = {}
        for place, arguments in enumerate(runs):
            feedback.pushCommandInfo("firebreak " + " ".join(_shown(word) for word in arguments))
            result = run(engine, arguments, _listener(feedback, place, len(runs)), folder=str(folder))
        return result

    def _run_of(self, engine: Engine, values: dict[str, Any], mark: str) -> Run:
        """Return what the layers of this run have in common: runs of one form are told apart by ranking and time."""
        now = datetime.now().astimezone()
        rankings = [
            translated(word).partition(":")[0].strip()  # French has a space before it
            for field in self._description.fields
            if field.option == "method"
            for choice, word in zip(field.choices, field.words)  # noqa: B905 - QGIS may run Python 3.9
            if choice == values[field.name]
        ]
        title = f"{self.displayName()} ({', '.join([*rankings, f'{now:%H:%M}'])})"
        given = [
            f"{field_label(field)}: {_listed(values[field.name])}"
            for field in self._description.fields
            if values[field.name] not in (None, "", [], False, field.default)
        ]
        made = f"{now:%Y-%m-%d %H:%M}: {self.displayName()}, firebreak_gis {engine.version}"
        return Run(mark, title, self.shortDescription(), (made, *given))

    def _tell(self, result: dict[str, Any], feedback: QgsProcessingFeedback) -> None:
        """Show the figures of the result."""
        for key, value in result.items():
            if isinstance(value, (int, float, str)) and not isinstance(value, bool):
                text = translated(self._description.form.numbers.get(key, "")) or key.replace("_", " ")
                feedback.pushInfo(f"{text}: {value:g}" if isinstance(value, float) else f"{text}: {value}")

    def _main_output(self) -> Output:
        return self._description.outputs[0]

    def _deliver(
        self,
        result: dict[str, Any],
        wanted: dict[str, str],
        made: Path,
        run_of: Run,
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
    ) -> dict[str, Any]:
        self._tell(result, feedback)
        delivered: dict[str, Any] = {}
        for output in self._description.outputs:
            path = wanted.get(output.name)
            if path is None:
                continue
            if output.kind == "folder":
                deliver_folder(made / output.file, Path(path))
                delivered[output.name] = path
                continue
            file = made / output.file_for(path)
            if not file.is_file():
                message = translate("Firebreak", "{} was not made: there is nothing to put in it.")
                feedback.pushWarning(message.format(output.name))
                continue
            if output.kind == "vector":
                deliver_vector(file, Path(path), context, feedback)
            else:
                deliver(file, Path(path))
            if output.kind != "file":
                style_later(output, path, run_of, context)
            elif output.file == "report.html":
                message = translate("Firebreak", "Report: {} (open it from the Results Viewer)")
                feedback.pushInfo(message.format(path))
            delivered[output.name] = path
        numbers = {key.upper(): result[key] for key in self._description.form.numbers if key in result}
        return {**delivered, **numbers}


def _listener(feedback: QgsProcessingFeedback, place: int, count: int) -> Listener:
    """Return a listener that shows the progress of one of several runs as a part of the whole."""
    texts = [""]

    def progress(fraction: float, message: str) -> None:
        feedback.setProgress(100.0 * (place + fraction) / count)
        if message != texts[0]:
            texts[0] = message
            feedback.setProgressText(message)

    def warn(text: str) -> None:
        feedback.pushWarning(in_form_words(text))

    def say(text: str) -> None:
        feedback.pushInfo(in_form_words(text))

    return Listener(progress, warn, say, feedback.isCanceled)


def _listed(value: Any) -> str:
    return ", ".join(map(str, value)) if isinstance(value, (list, tuple)) else str(value)


def _shown(word: str) -> str:
    return f'"{word}"' if " " in word else word
