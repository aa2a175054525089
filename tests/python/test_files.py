"""Written files appear whole under their names, and touch nothing else."""

import os
import stat
import threading

import pytest

import voroproof as vp
from voroproof.files import whole_file, write_whole


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_page_leaves_the_files_beside_it(tmp_path):
    history = vp.simulate(vp.Scene.reference(5, horizon=5))
    (tmp_path / "x.html.tmp").write_text("the user's")
    (tmp_path / "elsewhere").write_text("the user's, too")
    (tmp_path / "y.html.tmp").symlink_to("elsewhere")
    history.write_movie(tmp_path / "x.html")
    history.write_movie(tmp_path / "y.html")
    assert (tmp_path / "x.html.tmp").read_text() == "the user's"
    assert (tmp_path / "elsewhere").read_text() == "the user's, too"
    assert names(tmp_path) == ["elsewhere", "x.html", "x.html.tmp", "y.html", "y.html.tmp"]


def test_a_link_stays_and_its_file_is_replaced(tmp_path):
    (tmp_path / "there").mkdir()
    (tmp_path / "there" / "a").write_text("old")
    (tmp_path / "link").symlink_to("there/a")
    (tmp_path / "dangling").symlink_to("there/b")
    write_whole(tmp_path / "link", "new")
    write_whole(tmp_path / "dangling", "made")
    assert (tmp_path / "link").is_symlink() and (tmp_path / "dangling").is_symlink()
    assert (tmp_path / "there" / "a").read_text() == "new"
    assert (tmp_path / "there" / "b").read_text() == "made"


def test_permissions(tmp_path):
    mask = os.umask(0o027)
    try:
        write_whole(tmp_path / "new", "")
        assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o640
        (tmp_path / "new").chmod(0o604)
        write_whole(tmp_path / "new", "")
        assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o604
    finally:
        os.umask(mask)


def test_what_fails_leaves_what_was_there(tmp_path):
    (tmp_path / "a").write_text("old")
    with pytest.raises(ZeroDivisionError):
        with whole_file(tmp_path / "a") as file:
            file.write("half")
            file.write(str(1 // 0))
    with pytest.raises(IsADirectoryError):
        write_whole(tmp_path, "a folder")
    with pytest.raises(FileNotFoundError):
        write_whole(tmp_path / "none" / "a", "no folder")
    assert (tmp_path / "a").read_text() == "old" and names(tmp_path) == ["a"]


def test_a_pipe_is_written_to(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    got = []
    reader = threading.Thread(target=lambda: got.append((tmp_path / "pipe").read_text()))
    reader.start()
    write_whole(tmp_path / "pipe", "text")
    reader.join()
    assert got == ["text"] and names(tmp_path) == ["pipe"]
