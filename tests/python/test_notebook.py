"""Notebooks show the player in a frame, a scene as a picture, text where it would be too large."""

import html
import json
import os
import re
import subprocess
from xml.etree import ElementTree

import numpy as np
import pytest

import voroproof as vp
from voroproof import notebook


@pytest.fixture(scope="module")
def history():
    return vp.simulate(vp.Scene.reference(12, horizon=30))


def page_of(shown):
    assert "\n" not in shown
    frame = re.fullmatch(r'<iframe srcdoc="([^"]*)" title="[^"]*" sandbox="([^"]*)" [^>]*></iframe>', shown)
    assert frame, shown[:200]
    return html.unescape(frame[1]), frame[2].split()


def facts_of(page):
    return json.loads(re.search(r'id="movie-facts">(.*?)</script>', page)[1])


def test_a_history_shows_the_player(history):
    page, may = page_of(history._repr_html_())
    assert page == history.movie_page()
    # A frame of the notebook's own origin could reach its page.
    assert "allow-same-origin" not in may and "allow-scripts" in may
    facts = facts_of(page)
    assert facts["end"] == 30 and facts["historyBy"] == history.producer


@pytest.mark.skipif("VOROPROOF_PROGRAM" not in os.environ, reason="the program is not built")
def test_the_page_is_the_one_that_the_program_makes(history, tmp_path):
    history.scene.write(tmp_path / "a.scene.json")
    history.write(tmp_path / "a.history.jsonl")
    read = vp.History.read(tmp_path / "a.history.jsonl", vp.Scene.read(tmp_path / "a.scene.json"))
    report = vp.certify(read.scene, read)
    read.write_movie(tmp_path / "mine.html", report=report, follow=3)
    report.write(tmp_path / "a.report.json")
    done = subprocess.run([os.environ["VOROPROOF_PROGRAM"], "movie", "a.scene.json", "a.history.jsonl", "--report", "a.report.json",
                           "--follow", "3", "-o", "its.html"], cwd=tmp_path)
    assert done.returncode == 0
    assert (tmp_path / "mine.html").read_bytes() == (tmp_path / "its.html").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir() if p.suffix == ".tmp") == []


def test_a_refutation_is_in_the_page(history):
    wrong = history.with_events(np.delete(history.events, 4))
    report = vp.certify(history.scene, wrong)
    facts = facts_of(wrong.movie_page(report=report))
    assert facts["report"]["verdict"] == "REFUTED" and facts["report"]["fault"]["line"] == report.divergence.line


def test_a_page_has_its_errors(history):
    with pytest.raises(ValueError, match="no disk 12"):
        history.movie_page(follow=12)
    other = vp.Scene.reference(5, horizon=5)
    with pytest.raises(vp.InputError, match="another scene"):
        history.movie_page(report=vp.certify(other, vp.simulate(other)))


def test_what_is_long_is_told(history, monkeypatch):
    monkeypatch.setattr(notebook, "MAX_EVENTS", len(history) - 1)
    shown = history._repr_html_()
    assert "<iframe" not in shown and "write_movie" in shown and f"beyond {len(history) - 1} events" in shown
    monkeypatch.setattr(notebook, "MAX_EVENTS", len(history))
    assert "<iframe" in history._repr_html_()
    monkeypatch.setattr(notebook, "MAX_DISKS", 11)
    assert "<iframe" not in history._repr_html_() and "<svg" not in history.scene._repr_html_()


def test_what_is_shown_is_bounded():
    history = vp.simulate(vp.Scene.reference(100, horizon=100))
    assert len(history._repr_html_()) < 150_000 + 40 * len(history) + 150 * len(history.scene)


def test_without_its_scene_a_history_is_told(history, tmp_path):
    history.write(tmp_path / "a.history.jsonl")
    shown = vp.History.read(tmp_path / "a.history.jsonl")._repr_html_()
    assert "<iframe" not in shown and "without its scene" in shown


def test_what_is_no_history_is_told(history):
    events = history.events.copy()
    events["ids"][0] = 99
    shown = history.with_events(events)._repr_html_()
    assert "<iframe" not in shown and "No player" in shown


@pytest.mark.parametrize("n", [0, 1, 5])
def test_a_scene_is_drawn(n):
    scene = vp.Scene({"name": "<few> & \"odd\"", "container": {"center": [7, "1/3"], "radius": 10}, "horizon": 1, "disks": [
        {"center": [3 + k, "1/3"], "radius": "1/3", "velocity": [0, 1]} for k in range(n)]})
    shown = ElementTree.fromstring(f"<div>{scene._repr_html_()}</div>")
    circles = shown.findall(".//{http://www.w3.org/2000/svg}circle")
    assert len(circles) == n + 1
    if n:
        assert float(circles[1].get("cx")) == pytest.approx(-0.4) and float(circles[1].get("cy")) == pytest.approx(0)
    assert shown.find("p").text == repr(scene)
    page, _ = page_of(vp.simulate(scene)._repr_html_())
    assert facts_of(page)["container"] == {"x": 7, "y": 1 / 3, "radius": 10}
