"""Photos turned into stylised comic and storyboard pages.

    import inkpanel

    drawn = inkpanel.stylize(array, "comic")  # uint8 (height, width, 3) in and out
    page = inkpanel.render(["a.jpg", "b.jpg", "c.jpg"], style="noir", seed=7)
    open("page.png", "wb").write(page.png())
    inkpanel.book("photos", "book.pdf")  # a cover, chapters by day, captions, page numbers and an end page

The same arguments give the same pixels, as the command line `inkpanel` gives them. Whatever takes long is done without the
interpreter's lock, and on all cores; the environment variable `RAYON_NUM_THREADS`, set before the first call, says on how many.
What cannot be done raises `inkpanel.Error`. A process that has worked must not be forked: start others by `spawn`, as Ray,
Dask and `multiprocessing` with `get_context("spawn")` do.
"""

from __future__ import annotations

import json as _json
import os as _os
from pathlib import Path as _Path

from ._inkpanel import Error, Page, __version__, blocks, layouts, styles
from . import _inkpanel

__all__ = ["Error", "Page", "__version__", "blocks", "book", "layouts", "pdf", "render", "styles", "stylize"]

# The nets that come with the wheel.
_MODELS = _Path(__file__).parent / "models"
# Endings of the pictures of a folder.
_PICTURES = {".jpg", ".jpeg", ".jpe", ".png", ".webp", ".gif", ".bmp", ".tif", ".tiff"}


def stylize(array, style, *, seed=None):
    """Draws an image in a style.

    array: uint8, of the shape (height, width, 3) in RGB or (height, width) in gray, of at most 120 million pixels. Arrays that
        are not contiguous are read as they are. A picture of PIL is `numpy.asarray(picture.convert("RGB"))`.
    style: the id of a designed style, as `styles()` lists them, or a style file as a dict.
    seed: a number from 0 to 2**32 - 1 for the blocks of the style that leave something to chance; as the style says where
        nothing is told.

    Returns a new uint8 array of the same height and width: (height, width, 3), or (height, width) where the array is gray and
    the style gives it no colour.

    Raises `Error` with the code `invalid-array` (shape, dtype), `damaged` (a side of 0), `too-large`, `unknown-style` or
    `invalid-style`; TypeError for what is no array.
    """
    return _inkpanel.stylize(array, _json.dumps(_choice(style), default=_plain), _whole("seed", seed))


def render(
    photos,
    *,
    layout=None,
    style=None,
    panels=None,
    pages=None,
    seed=1,
    page_size=None,
    width=None,
    dpi=None,
    gutter=None,
    margin=None,
    border=None,
    corner_radius=None,
    paper=None,
    border_color=None,
    merge=False,
    detect=True,
    models=None,
    words=None,
    fonts=(),
    star=(),
    alike=None,
    keep_all=False,
    as_given=False,
    skip_broken=False,
    _book=None,
):
    """Makes a storyboard page of photos, or several.

    photos: a list of paths, of files as bytes, or of uint8 arrays as `stylize` takes them, in any mixture, in the order of the
        story; or one of these. Where all files say when they were taken, that is the order, unless `as_given`.
    layout: the id of a page template (`layouts()`), or a layout file as a dict; chosen by the photos where nothing is told.
    style: the id of a designed style (`styles()`), or a style file as a dict; chosen by seed and photos where nothing is told.
    panels: the number of panels, where the layout is free.
    pages: a number from 1 to 1000 cuts an album where time or scene changes, and gives a list of at most so many pages in
        one style; None, the default, makes one page of all photos.
    seed: from 0 to 2**32 - 1, of what is left to chance.
    page_size: a name ("a4", "a5", "letter", "us-comic", "square", "webtoon"), a size on paper ("210x297mm", "8.5x11in"), or
        (width, height) in pixels, each from 64 to 14000 and together at most 72 million pixels; A4 where nothing is told.
    width: in pixels, from 64 to 14000; the paper stays as large.
    dpi: pixels an inch, from 36 to 1200; a size by name or on paper then has as many pixels as that makes.
    gutter, margin, border, corner_radius: as a part of the page's width.
    paper, border_color: as "#rrggbb".
    merge: whether panels may share one image.
    detect: whether faces and objects are looked for, so that no crop cuts them. That takes most of the time of planning.
    models: the folder of faces.onnx and objects.onnx; those in the wheel where nothing is told.
    words: captions, balloons and sound effects of the first page, as a list of dicts such as
        {"kind": "balloon", "text": "Look out!", "panel": 0}; those without a place go where they hide no face.
    fonts: paths of TrueType or OpenType files for letters of words that the program's own fonts lack, such as Arabic or Japanese;
        the first that has a letter is taken, and `Page.notes` tells what none has.
    star: places in `photos`, from 0, of those that get a large panel.
    alike: photos whose fingerprints differ in at most so many of 64 bits show the same picture; 10 where nothing is told.
    keep_all: use all photos, those that look alike and those that are blurred, too.
    skip_broken: leave photos out that cannot be read, rather than raise; `Page.notes` tells them.

    Returns a `Page`, or a list of them where `pages` is told.

    Raises `Error`. A photo that cannot be read has the codes `not-found`, `unreadable`, `unknown-format`, `damaged`,
    `unsupported` or `too-large`, and its path as `file`; the others are `no-photos`, `unknown-style`, `invalid-style`,
    `unknown-layout`, `invalid-layout`, `invalid-document` (a setting out of range, words), `invalid-argument`, `invalid-array`
    and `no-models`. TypeError for what is no photo.
    """
    if isinstance(photos, (str, bytes, _os.PathLike)) or hasattr(photos, "dtype"):
        photos = [photos]
    settings = {
        "layout": _choice(layout),
        "style": _choice(style),
        "panels": panels,
        "pages": pages,
        "seed": seed,
        "page_size": page_size,
        "width": width,
        "dpi": dpi,
        "gutter": gutter,
        "margin": margin,
        "border": border,
        "corner_radius": corner_radius,
        "paper": paper,
        "border_color": border_color,
        "merge": merge,
        "models": (_os.fspath(models) if models else str(_MODELS)) if detect else None,
        "words": words,
        "fonts": [_os.fspath(font) for font in fonts],
        "star": list(star),
        "alike": alike,
        "keep_all": keep_all,
        "as_given": as_given,
        "skip_broken": skip_broken,
        "book": _book,
    }
    made = _inkpanel.render(list(photos), _json.dumps(settings, default=_plain))
    return made[0] if pages is None and _book is None else made


def book(
    photos,
    output=None,
    *,
    title=None,
    language="en",
    styles="one",
    pages=None,
    style=None,
    seed=1,
    page_size=None,
    width=None,
    dpi=None,
    detect=True,
    models=None,
    fonts=(),
    star=(),
    alike=None,
    keep_all=False,
    as_given=False,
    skip_broken=False,
):
    """Makes a book: a cover, chapters by day with captions, page numbers and an end page.

    `photos` is a folder, or a list of photos. Names of folders within the folder are places.

    `output` is the name of a PDF file, to which the book is written.

    `title` is on the cover. Default: the name of the folder, or the places or days of the photos.

    `language` is the language of the captions: "en", "de", "es", "fr", "ja" or "pt".

    `styles` is "one" for one style, or "chapters" for another style for each day.

    `pages` is the number of pages with cover and end page, from 3 to 1000. Default: as many as the photos need.

    `render` explains the other arguments.

    Returns the list of pages.

    Raises the errors of `render`, and `ValueError` for an output that is not a PDF file.
    """
    if output is not None and _Path(output).suffix.lower() != ".pdf":
        raise ValueError(f"output: must end in .pdf, not {_os.fspath(output)}")
    if isinstance(photos, (str, _os.PathLike)) and _Path(photos).is_dir():
        folder = _Path(photos)
        title = folder.resolve().name if title is None else title
        photos = _pictures(folder)
    made = render(
        photos,
        style=style,
        seed=seed,
        page_size=page_size,
        width=width,
        dpi=dpi,
        detect=detect,
        models=models,
        fonts=fonts,
        star=star,
        alike=alike,
        keep_all=keep_all,
        as_given=as_given,
        skip_broken=skip_broken,
        _book={"title": title or "", "language": language, "styles": styles, "pages": pages},
    )
    if output is not None:
        _Path(output).write_bytes(pdf(made, title=title or "", language=language))
    return made


def _pictures(folder):
    """The pictures of a folder and of its folders, by name."""
    found = (file for file in sorted(folder.rglob("*")) if file.suffix.lower() in _PICTURES)
    return [
        file
        for file in found
        if file.is_file() and not any(part.startswith(".") for part in file.relative_to(folder).parts)
    ]


def pdf(pages, *, title="", language="en"):
    """One PDF file, as bytes, of a list of pages; `language` is a tag such as "pt-BR".

    Raises `Error`: `invalid-argument` where there is no page, and where a photo is there no more what `render` raises for it.
    """
    return _inkpanel.pdf(list(pages), title, language)


def _choice(told):
    """A style or a layout: an id, or a file as a dict."""
    if told is None or isinstance(told, (str, dict)):
        return told
    raise TypeError(f"a style or a layout is an id or a dict, not {type(told).__name__}")


def _whole(name, number):
    if number is None:
        return None
    # Of numpy, too.
    number = number.__index__()
    if not 0 <= number < 1 << 32:
        raise Error(f"{name}: must be from 0 to 4294967295, not {number}")
    return number


def _plain(value):
    """Numbers of numpy as those of Python."""
    if hasattr(value, "__index__"):
        return value.__index__()
    if hasattr(value, "__float__"):
        return float(value)
    raise TypeError(f"{type(value).__name__} is nothing that Inkpanel takes")
