"""The package as it is installed: catalogues, types, help, threads, and the example of the README."""

import inspect
import re
import subprocess
import sys
import threading
import time
from importlib import metadata, resources
from pathlib import Path

import inkpanel
import numpy as np
from conftest import ROOT, SAMPLES, made_up


def test_it_is_tested_as_it_was_installed():
    assert ROOT not in Path(inkpanel.__file__).parents or "target" in Path(inkpanel.__file__).parts
    assert inkpanel.__version__ == metadata.version("inkpanel")
    files = {file.name for file in resources.files("inkpanel").iterdir()}
    assert {"py.typed", "__init__.pyi", "models"} <= files
    assert {"faces.onnx", "objects.onnx", "README.md"} <= {file.name for file in resources.files("inkpanel").joinpath("models").iterdir()}
    licences = metadata.distribution("inkpanel").files
    assert {"LICENSE-MIT", "LICENSE-APACHE"} <= {file.name for file in licences}


def test_catalogues():
    styles, layouts, blocks = inkpanel.styles(), inkpanel.layouts(), inkpanel.blocks()
    stored = {file.stem for file in (ROOT / "styles").glob("*.json")}
    assert {style["id"] for style in styles} == stored
    assert {layout["id"] for layout in layouts} == {file.stem for file in (ROOT / "layouts").glob("*.json")}
    gaussian = next(block for block in blocks if block["id"] == "gaussian")
    assert {param["id"] for param in gaussian["params"]} >= {"sigma"}
    # The listed ids are valid arguments.
    assert inkpanel.stylize(made_up(1), styles[0]).shape == (90, 120, 3)


def test_everything_says_what_it_does():
    for name in inkpanel.__all__:
        if name != "__version__":
            assert len(inspect.getdoc(getattr(inkpanel, name)).split()) > 3, name
    for name in ["image", "plan", "png", "jpeg", "pdf", "notes", "width", "height"]:
        assert inspect.getdoc(getattr(inkpanel.Page, name)), name


def test_the_types_tell_the_same_arguments():
    told = resources.files("inkpanel").joinpath("__init__.pyi").read_text()
    for function in (inkpanel.render, inkpanel.stylize, inkpanel.pdf):
        for heads in re.findall(rf"^def {function.__name__}\((.*?)\) ->", told, re.DOTALL | re.MULTILINE):
            names = re.findall(r"(?:^|, )\s*(?:\*\*)?(\w+): ", heads, re.MULTILINE)
            parameters = inspect.signature(function).parameters
            assert names == [name for name in parameters if not name.startswith("_")], function.__name__


def steps_meanwhile(work):
    """How often another thread came to its turn in Python while `work` was done, and how long that took."""
    steps, done = 0, threading.Event()
    worker = threading.Thread(target=lambda: (work(), done.set()))
    start = time.perf_counter()
    worker.start()
    while not done.is_set():
        time.sleep(0.001)
        steps += 1
    worker.join()
    return steps, time.perf_counter() - start


def test_other_threads_run_meanwhile(samples):
    picture = np.tile(made_up(1, 500, 500), (4, 4, 1))
    files = samples[:6]
    page = inkpanel.render(files, page_size="a4", dpi=200, style="comic")
    for work in [
        lambda: inkpanel.stylize(picture, "gouache"),
        lambda: inkpanel.render(files, style="comic"),
        lambda: page.image,
        page.png,
        page.pdf,
    ]:
        steps, took = steps_meanwhile(work)
        # With the lock held there would be one or two.
        assert steps > min(10, took * 100), (steps, took)


def test_two_threads_draw_the_same_as_one(album):
    alone = inkpanel.render(album, width=300, detect=False).png()
    shared = inkpanel.render(album, width=300, detect=False)
    drawn = []
    threads = [
        threading.Thread(target=lambda: drawn.append(shared.png())),
        threading.Thread(target=lambda: drawn.append(shared.png())),
        threading.Thread(target=lambda: drawn.append(inkpanel.render(album, width=300, detect=False).png())),
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert drawn == [alone] * 3


def test_the_readmes_example_draws_a_page(tmp_path):
    readme = (ROOT / "python/README.md").read_text()
    example = re.search(r"```python\n(.*?)```", readme, re.DOTALL)[1]
    assert len(example.splitlines()) == 10
    photos = tmp_path / "photos"
    photos.mkdir()
    for file in sorted(SAMPLES.glob("*.jpg"))[:7]:
        (photos / file.name).write_bytes(file.read_bytes())
    subprocess.run([sys.executable, "-c", example], cwd=tmp_path, check=True)
    assert (tmp_path / "page.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "page.pdf").read_bytes().startswith(b"%PDF")
