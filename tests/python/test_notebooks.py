"""The notebooks run from top to bottom, draw, and say what they are there to show."""

import os
import pathlib

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")
pytest.importorskip("matplotlib")

FOLDER = pathlib.Path(os.environ["VOROPROOF_SOURCE"]) / "docs" / "notebooks"

SAID = {
    "catchment-areas": ["Potsdam is hidden by Berlin", "Cologne and Düsseldorf overlap by 11 km", "13 cells of 14 cities"],
    "certify-your-engine": ["recorded: CERTIFIED", "exact:    REFUTED", "in single precision       REFUTED",
                            "99.9 % elastic            REFUTED", "one collision forgotten   REFUTED",
                            "confirmed"],
    "degenerate-cases": ["CERTIFIED"],
    "gas-of-disks": ["scaled particle theory", "CERTIFIED"],
    "plan-a-swarm": ["found: True", "0 collisions", "no plan", "CERTIFIED"],
}


def test_all_are_known():
    assert {path.stem for path in FOLDER.glob("*.ipynb")} == set(SAID)


@pytest.mark.parametrize("name", SAID)
def test_runs(name, tmp_path, monkeypatch):
    # The notebook's own way to draw.
    monkeypatch.delenv("MPLBACKEND", raising=False)
    notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    # The committed notebooks hold no outputs: they are made anew.
    assert not any(cell.get("outputs") for cell in notebook.cells)
    nbclient.NotebookClient(notebook, timeout=250, kernel_name="python3",
                            resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    text = "".join(output.get("text", "") for output in outputs)
    for words in SAID[name]:
        assert words in text, f"{words!r} is not in\n{text}"
    assert any("image/png" in output.get("data", {}) for output in outputs)
