"""Pages: sizes, files, content and errors."""

import io
import os
import pickle
import re
import subprocess

import inkpanel
import numpy as np
import pytest
from conftest import ROOT, file_of, made_up
from PIL import Image


def opened(file):
    with Image.open(io.BytesIO(file)) as picture:
        picture.load()
        return picture


@pytest.mark.skipif("INKPANEL" not in os.environ, reason="the variable INKPANEL names no command line")
@pytest.mark.parametrize("style, seed, detect", [("comic", 7, True), ("gouache", 99, False), (None, 3, False)])
def test_the_command_line_draws_the_same(samples, tmp_path, style, seed, detect):
    out = tmp_path / "page.png"
    files = [str(file) for file in samples[:9]]
    options = ["--width", "300", "--seed", str(seed)]
    options += ["--style", style] if style else []
    options += ["--models", ROOT / "www/models"] if detect else ["--no-detect"]
    subprocess.run([os.environ["INKPANEL"], "render", *options, "-o", out, *files], check=True)
    page = inkpanel.render(files, width=300, style=style, seed=seed, detect=detect)
    np.testing.assert_array_equal(page.image, np.asarray(Image.open(out)))
    assert page.png() == out.read_bytes()


def test_files_of_a_page_are_what_pillow_reads(album):
    page = inkpanel.render(album, page_size="a6", dpi=100, style="noir", detect=False)
    assert (page.width, page.height, page.dpi) == (413, 583, 100)
    assert page.image.shape == (583, 413, 3)
    png = opened(page.png())
    assert (png.format, png.mode, png.size) == ("PNG", "RGB", (413, 583))
    np.testing.assert_array_equal(np.asarray(png), page.image)
    assert png.info["dpi"] == pytest.approx((100, 100), abs=0.1)
    jpeg = opened(page.jpeg(quality=95))
    assert (jpeg.format, jpeg.size, jpeg.info["dpi"]) == ("JPEG", (413, 583), (100, 100))
    assert np.abs(np.asarray(jpeg.convert("RGB")).astype(int) - page.image).mean() < 12
    assert len(page.jpeg(quality=20)) < len(page.jpeg(quality=95))
    assert page._repr_png_() == page.png()


def test_a_pdf_is_as_large_as_its_paper(album):
    page = inkpanel.render(album, page_size="a6", dpi=100, style="noir", detect=False)
    file = page.pdf(title="Four", language="de")
    assert file.startswith(b"%PDF-1.") and file.rstrip().endswith(b"%%EOF")
    box = re.search(rb"/MediaBox *\[ *([\d. ]+)\]", file)
    assert [float(side) for side in box[1].split()] == pytest.approx([0, 0, 413 * 0.72, 583 * 0.72], abs=0.01)
    assert len(re.findall(rb"/Type */Page\b", file)) == 1
    assert b"/Lang(de)" in file


def test_pages_of_a_book():
    photos = [made_up(seed) for seed in range(9)]
    pages = inkpanel.render(photos, pages=3, width=200, detect=False, seed=3)
    assert isinstance(pages, list) and len(pages) == 3
    shown = [panel["photo"] for page in pages for panel in page.plan["panels"]]
    assert set(shown) == {f"photo {place}" for place in range(9)}
    assert len(re.findall(rb"/Type */Page\b", inkpanel.pdf(pages))) == 3
    with pytest.raises(inkpanel.Error, match="no page"):
        inkpanel.pdf([])


def test_paths_bytes_and_arrays_are_one(album):
    """PNG keeps pixels, so that all three hold the same."""
    files = []
    for place, file in enumerate(album):
        png = file.with_suffix(".png")
        Image.fromarray(made_up(place)).save(png)
        files.append(png)
    ways = [files, [str(file) for file in files], [file.read_bytes() for file in files]]
    ways += [[made_up(place) for place in range(4)], (made_up(place) for place in range(4))]
    drawn = [inkpanel.render(way, width=300, seed=5, detect=False).image for way in ways]
    for other in drawn[1:]:
        np.testing.assert_array_equal(drawn[0], other)


def test_the_plan_is_the_document(album):
    page = inkpanel.render(album, layout="cinema-4", style="noir", width=320, seed=3, gutter=0.02, detect=False)
    plan = page.plan
    assert (plan["layout"], plan["style"]["id"], plan["seed"]) == ("cinema-4", "noir", 3)
    assert plan["page"]["width"] == 320 and plan["page"]["gutter"] == 0.02
    assert {panel["photo"] for panel in plan["panels"]} == {str(file) for file in album}
    for panel in plan["panels"]:
        assert 0 <= panel["crop"]["x"] <= 1 and 0 < panel["crop"]["width"] <= 1


def test_the_same_seed_gives_the_same_page(album):
    pages = [inkpanel.render(album, seed=seed, width=200, detect=False) for seed in (1, 1, 2)]
    assert pages[0].plan == pages[1].plan and pages[0].png() == pages[1].png()
    assert pages[0].plan != pages[2].plan


def test_a_single_photo_need_not_be_a_list(album):
    for photo in [album[0], str(album[0]), album[0].read_bytes(), made_up(0)]:
        assert inkpanel.render(photo, width=100, detect=False).width == 100


def test_gray_files_and_arrays(tmp_path):
    gray = made_up(1)[..., 0]
    file = tmp_path / "gray.png"
    Image.fromarray(gray).save(file)
    pages = [inkpanel.render(photo, width=200, style="noir", detect=False) for photo in (gray, file)]
    np.testing.assert_array_equal(pages[0].image, pages[1].image)


def test_fonts_give_letters_that_the_program_lacks(album):
    said = [{"kind": "balloon", "text": "漢字 مرحبا", "panel": 0}]
    fonts = [ROOT / "tests/oracles/data/fonts" / name for name in ("japanese.ttf", "arabic.ttf")]
    how = {"layout": "cinema-4", "style": "comic", "width": 500, "detect": False, "words": said}
    bare, given = inkpanel.render(album, **how), inkpanel.render(album, **how, fonts=fonts)
    assert any("no font has these letters" in note and "漢" in note for note in bare.notes)
    assert not given.notes and (given.image != bare.image).any() and given.pdf() != bare.pdf()
    with pytest.raises(inkpanel.Error, match="no TrueType") as raised:
        inkpanel.render(album, fonts=[__file__])
    assert raised.value.code == "invalid-argument"


def test_edits_change_planned_pages(album):
    how = {"layout": "cinema-4", "style": "comic", "width": 300, "detect": False}
    shown = lambda page: [panel["photo"] for panel in page.plan["panels"]]  # noqa: E731
    before = shown(inkpanel.render(album, **how))
    swap = {"type": "swap-panels", "panel": 0, "with": 3}
    after = shown(inkpanel.render(album, **how, edits=[swap]))
    assert (after[0], after[3]) == (before[3], before[0])
    idle = inkpanel.render(album, **how, edits=[{**swap, "with": 99}])
    assert shown(idle) == before and any("changes nothing" in note for note in idle.notes)
    with pytest.raises(inkpanel.Error, match="is not a known edit") as raised:
        inkpanel.render(album, **how, edits=[{"type": "swap"}])
    assert raised.value.code == "invalid-document"


def test_words_stars_and_sizes(album):
    plain = inkpanel.render(album, layout="cinema-4", style="comic", width=500, detect=False)
    said = [{"kind": "balloon", "text": "Look out!", "panel": 0}]
    page = inkpanel.render(album, layout="cinema-4", style="comic", width=500, detect=False, words=said)
    assert page.plan["words"][0]["text"] == "Look out!" and (page.image != plain.image).any()
    assert inkpanel.render(album, page_size=(300, 450), detect=False).image.shape == (450, 300, 3)
    assert inkpanel.render(album, page_size="letter", dpi=36, detect=False).width == 306
    paper = inkpanel.render(album, width=200, paper="#204060", margin=0.05, detect=False)
    assert tuple(paper.image[0, 0]) == (0x20, 0x40, 0x60)
    starred = inkpanel.render(album, width=200, star=[np.int64(2)], detect=False)
    assert starred.width == 200


def test_the_image_is_kept_and_not_written_to(album):
    page = inkpanel.render(album, width=200, detect=False)
    assert page.image is page.image
    with pytest.raises(ValueError):
        page.image[0, 0] = 0


def test_look_alikes_are_left_out_and_told(album):
    twice = [*album, album[0]]
    page = inkpanel.render(twice, width=200, detect=False)
    assert any("left out" in note and str(album[0]) in note for note in page.notes)
    assert inkpanel.render(twice, width=200, detect=False, keep_all=True).notes == []


@pytest.mark.parametrize(
    "broken, code",
    [
        (b"", "unknown-format"),
        (b"no picture", "unknown-format"),
        (b"\xff\xd8\xff\xe0" + bytes(60), "damaged"),
        (file_of(made_up(1))[:400], "damaged"),
        (file_of(made_up(1), "PNG")[:400], "damaged"),
    ],
)
def test_a_broken_photo_is_named(album, broken, code):
    album[2].write_bytes(broken)
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.render(album, detect=False)
    assert error.value.code == code
    assert error.value.file == str(album[2]) and str(album[2]) in str(error.value)
    page = inkpanel.render(album, detect=False, width=200, skip_broken=True)
    assert [note for note in page.notes if str(album[2]) in note]
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.render([album[0].read_bytes(), broken], detect=False)
    assert (error.value.code, error.value.file) == (code, "photo 1")


def test_missing_files_and_folders_are_named(album, tmp_path):
    missing = tmp_path / "missing.jpg"
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.render([*album, missing], detect=False)
    assert (error.value.code, error.value.file) == ("not-found", str(missing))
    with pytest.raises(inkpanel.Error, match="list the files") as error:
        inkpanel.render(tmp_path, detect=False)
    assert error.value.code == "unreadable"
    # A photo that is deleted before the page is drawn.
    page = inkpanel.render(album, width=200, detect=False)
    for file in album:
        file.unlink()
    for draw in (page.png, page.pdf, lambda: page.image):
        with pytest.raises(inkpanel.Error) as error:
            draw()
        assert error.value.code == "not-found" and error.value.file in map(str, album)


@pytest.mark.parametrize(
    "settings, code, says",
    [
        ({"style": "no-such"}, "unknown-style", "no-such"),
        ({"layout": "no-such"}, "unknown-layout", "no-such"),
        ({"layout": {"id": "x"}}, "invalid-layout", "name"),
        ({"style": {"background": 3}}, "invalid-style", "background"),
        ({"page_size": "a77"}, "invalid-document", "a4-landscape"),
        ({"page_size": (1, 2, 3)}, "invalid-argument", "page_size"),
        ({"page_size": (9000, 9000)}, "invalid-document", "million"),
        ({"width": 3}, "invalid-document", "page.width"),
        ({"width": "wide"}, "invalid-argument", "width"),
        ({"gutter": 0.9}, "invalid-document", "page.gutter"),
        ({"paper": "red"}, "invalid-document", "page.paper"),
        ({"seed": -1}, "invalid-argument", "seed"),
        ({"pages": 0}, "invalid-argument", "pages"),
        ({"panels": 2.5}, "invalid-argument", "panels"),
        ({"star": [9]}, "invalid-argument", "star"),
        ({"words": [{"kind": "shout"}]}, "invalid-document", "word"),
        ({"detect": True, "models": "nowhere"}, "no-models", "faces.onnx"),
    ],
)
def test_what_cannot_be_is_said(album, settings, code, says):
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.render(album, **{"detect": False, **settings})
    assert error.value.code == code and says in str(error.value)


def test_page_settings_have_names(album):
    page = inkpanel.render(album, detect=False, width=320, style="noir", rtl=True, corner_radius=0.01, paper="#123456")
    assert page.plan["page"]["rtl"] and page.plan["page"]["cornerRadius"] == 0.01
    assert {"gutter", "corner_radius", "border_color", "rtl"} <= inkpanel.page_settings().keys()
    with pytest.raises(TypeError, match="guter"):
        inkpanel.render(album, guter=0.01)


def test_no_photos():
    for nothing in ([], iter(())):
        with pytest.raises(inkpanel.Error) as error:
            inkpanel.render(nothing, detect=False)
        assert error.value.code == "no-photos"


@pytest.mark.parametrize("photo", [3, None, [1]])
def test_what_is_no_photo_is_a_type_error(photo):
    with pytest.raises(TypeError, match="photo 0"):
        inkpanel.render([photo], detect=False)


def test_arrays_among_photos_are_checked():
    with pytest.raises(inkpanel.Error, match="photo 1") as error:
        inkpanel.render([made_up(1), made_up(2).astype(float)], detect=False)
    assert error.value.code == "invalid-array"


def test_errors_go_from_process_to_process():
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.render([b"nothing"], detect=False)
    again = pickle.loads(pickle.dumps(error.value))
    assert type(again) is inkpanel.Error
    assert (str(again), again.code, again.file) == (str(error.value), "unknown-format", "photo 0")


def test_faces_are_found_by_the_nets_of_the_wheel(samples):
    """The astronaut's face must be complete in a wide panel."""
    photo = next(file for file in samples if "astronaut" in file.name)
    crops = {}
    for detect in (True, False):
        page = inkpanel.render(photo, layout="cinema-3", width=200, detect=detect, seed=1)
        crops[detect] = [panel["crop"] for panel in page.plan["panels"]]
    assert crops[True] != crops[False]


def test_photos_are_shown_whole(samples):
    page = inkpanel.render(samples[:6], panels=6, whole_photos=True, detect=False, keep_all=True, width=300)
    shown = [panel["crop"]["width"] * panel["crop"]["height"] for panel in page.plan["panels"]]
    assert len(shown) == 6 and min(shown) > 0.9


def test_a_folder_becomes_a_book(tmp_path, samples):
    for place, files in (("Lisbon", samples[:4]), ("Sintra", samples[4:8])):
        folder = tmp_path / "Iberia" / place
        folder.mkdir(parents=True)
        for file in files:
            (folder / file.name).write_bytes(file.read_bytes())
    output = tmp_path / "book.pdf"
    pages = inkpanel.book(tmp_path / "Iberia", output, width=200, style="noir", detect=False, keep_all=True)
    texts = [word["text"] for page in pages for word in page.plan["words"]]
    assert {"Iberia", "Lisbon.", "Sintra.", "The end", "2"} <= set(texts)
    assert output.read_bytes().startswith(b"%PDF")
    shown = {panel["photo"] for page in pages[1:] for panel in page.plan["panels"]}
    assert len(shown) == 8
    with pytest.raises(ValueError, match="PDF|pdf"):
        inkpanel.book(tmp_path / "Iberia", "book.png")
