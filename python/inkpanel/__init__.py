"""Turns photos into stylised comic pages.

    import inkpanel

    drawn = inkpanel.stylize(array, "comic")  # uint8 (height, width, 3) in and out
    page = inkpanel.render(["a.jpg", "b.jpg", "c.jpg"], style="noir", seed=7)
    open("page.png", "wb").write(page.png())
    inkpanel.book("photos", "book.pdf")  # a cover, chapters by day, captions, page numbers and an end page

The same arguments give the same pixels, also on the command line. Long functions release the interpreter's lock and use all
cores. The environment variable `RAYON_NUM_THREADS` limits the number of threads; set it before the first call. Invalid input
raises `inkpanel.Error`. Do not fork a process after the first call. Start processes with `spawn`, as Ray, Dask and
`multiprocessing` with `get_context("spawn")` do.
"""

from __future__ import annotations

import json as _json
import os as _os
from pathlib import Path as _Path

from ._inkpanel import Error, Page, __version__, blocks, layouts, styles
from . import _inkpanel

__all__ = ["Error", "Page", "__version__", "blocks", "book", "layouts", "page_settings", "pdf", "render", "styles", "stylize"]

# The models in the wheel.
_MODELS = _Path(__file__).parent / "models"
_inkpanel.find_painters(_MODELS)
_PAGE_SETTINGS = dict(_inkpanel.page_settings())


def stylize(array, style, *, seed=None):
    """Draws an image in a style.

    array: uint8 array of the shape (height, width, 3) in RGB or (height, width) in gray, with at most 120 million pixels. It need
        not be contiguous. Convert a PIL image with `numpy.asarray(image.convert("RGB"))`.
    style: id of a built-in style (see `styles()`), or a style file as a dict.
    seed: seed from 0 to 2**32 - 1 for random parts of the style. Default: the seed in the style.

    Returns a new uint8 array of the same height and width. Its shape is (height, width, 3), or (height, width) if the array is
    gray and the style adds no colour.

    Raises `Error` with the code `invalid-array` (shape, dtype), `damaged` (a side of 0), `too-large`, `unknown-style` or
    `invalid-style`. Raises TypeError if `array` is not an array.
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
    merge=False,
    detect=True,
    models=None,
    words=None,
    edits=None,
    fonts=(),
    star=(),
    duplicate_threshold=None,
    keep_all=False,
    as_given=False,
    skip_broken=False,
    _book=None,
    **page_settings,
):
    """Makes one comic page of photos, or several.

    photos: list of paths, image files as bytes, or uint8 arrays as in `stylize`, in story order. A single photo is allowed. If all
        files have a capture date, they are sorted by it, unless `as_given` is true.
    layout: id of a layout (see `layouts()`), or a layout file as a dict. Default: chosen to fit the photos.
    style: id of a built-in style (see `styles()`), or a style file as a dict. Default: chosen by seed and photos.
    panels: number of panels, if `layout` is None.
    pages: maximum number of pages, from 1 to 1000. Pages break where time or scene changes and share one style. The result is a
        list. Default: one page with all photos.
    seed: seed of random choices, from 0 to 2**32 - 1.
    page_size: a name ("a4", "a5", "letter", "us-comic", "square", "webtoon"), a paper size ("210x297mm", "8.5x11in"), or
        (width, height) in pixels, each from 64 to 14000, with at most 72 million pixels. Default: A4.
    width: width in pixels, from 64 to 14000. The paper size does not change.
    dpi: pixels per inch, from 36 to 1200. It sets the number of pixels of a named size or a paper size.
    merge: whether panels may share one image.
    detect: whether faces and objects are detected, so that crops do not cut them. Takes most of the planning time.
    models: folder with faces.onnx, objects.onnx and optionally landmarks.onnx. Default: the models in the wheel.
    words: captions, balloons and sound effects of the first page, as a list of dicts such as
        {"kind": "balloon", "text": "Look out!", "panel": 0}. Without a position, they are placed clear of faces.
    edits: edits of the planned pages, in order, as a list of dicts such as {"type": "swap-panels", "panel": 0, "with": 2}. The
        reference of formats lists them. `Page.notes` lists edits that change nothing.
    fonts: paths of TrueType or OpenType files for characters that the bundled fonts lack, such as Arabic or Japanese. The first
        font with a glyph is used. `Page.notes` lists missing glyphs.
    star: indices in `photos`, from 0, of photos for large panels.
    duplicate_threshold: maximum fingerprint distance at which photos count as duplicates, in bits of 64. `inkpanel render --help`
        prints the default.
    keep_all: use all photos, including similar and blurred ones.
    as_given: keep the order of the photos.
    skip_broken: leave out photos that cannot be read, instead of raising an error. `Page.notes` lists them.
    page_settings: gutter, margin, border, corner_radius, paper, border_color, rtl, whole_photos and all other settings that
        `page_settings()` lists.

    Returns a `Page`, or a list of pages if `pages` is set.

    Raises `Error`. If a photo cannot be read, the code is `not-found`, `unreadable`, `unknown-format`, `damaged`, `unsupported` or
    `too-large`, and `file` is its path. Other codes: `no-photos`, `unknown-style`, `invalid-style`, `unknown-layout`,
    `invalid-layout`, `invalid-document` (a setting out of range, words, edits), `invalid-argument`, `invalid-array` and `no-models`.
    Raises TypeError if an item is not a photo.
    """
    if isinstance(photos, (str, bytes, _os.PathLike)) or hasattr(photos, "dtype"):
        photos = [photos]
    if unknown := page_settings.keys() - _PAGE_SETTINGS.keys():
        raise TypeError(f"render() got an unexpected keyword argument {min(unknown)!r}")
    settings = {
        **page_settings,
        "layout": _choice(layout),
        "style": _choice(style),
        "panels": panels,
        "pages": pages,
        "seed": seed,
        "page_size": page_size,
        "width": width,
        "dpi": dpi,
        "merge": merge,
        "models": (_os.fspath(models) if models else str(_MODELS)) if detect else None,
        "words": words,
        "edits": edits,
        "fonts": [_os.fspath(font) for font in fonts],
        "star": list(star),
        "duplicate_threshold": duplicate_threshold,
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
    duplicate_threshold=None,
    keep_all=False,
    as_given=False,
    skip_broken=False,
    whole_photos=False,
    places=True,
):
    """Makes a book: a cover, chapters by day with captions, page numbers and an end page.

    photos: folder with pictures, also in subfolders, or photos as in `render`. Names of subfolders are places.
    places: whether the GPS data of photos names their places. The data stay in their files; captions get only the names.
    output: file name of the book, which must end in .pdf.
    title: title on the cover. Default: the name of the folder, or the places or days of the photos.
    language: language of the captions, a tag such as "pt-BR". English, German, Spanish, French, Japanese and Portuguese are supported.
    styles: "one" for one style, or "chapters" for another style for each day.
    pages: number of pages with cover and end page, from 3 to 1000. Default: as many as the photos need.

    The other arguments have the same meaning as in `render`.

    Returns the list of pages.

    Raises the errors of `render`, and `ValueError` if `output` is not the name of a PDF file.
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
        duplicate_threshold=duplicate_threshold,
        keep_all=keep_all,
        as_given=as_given,
        skip_broken=skip_broken,
        whole_photos=whole_photos,
        _book={
            "title": title or "",
            "language": language,
            "styles": styles,
            "pages": pages,
            "places": _place_names(models) if places else None,
        },
    )
    if output is not None:
        _Path(output).write_bytes(pdf(made, title=title or "", language=language))
    return made


def _place_names(models):
    """The table of places, if it exists."""
    table = (_MODELS if models is None else _Path(models)) / "places.bin"
    return str(table) if table.exists() else None


def _pictures(folder):
    """The pictures of a folder and of its folders, by name."""
    found = (file for file in sorted(folder.rglob("*")) if _inkpanel.is_photo(file.name))
    return [
        file
        for file in found
        if file.is_file() and not any(part.startswith(".") for part in file.relative_to(folder).parts)
    ]


def page_settings():
    """Returns the names of the page settings of `render`, each with its help text, as a dict."""
    return dict(_PAGE_SETTINGS)


def pdf(pages, *, title="", language="en"):
    """Returns one PDF file of a list of pages, as bytes. `language` is a tag such as "pt-BR".

    Raises `Error`: `invalid-argument` if the list is empty, and an error of `render` if a photo was deleted.
    """
    return _inkpanel.pdf(list(pages), title, language)


def _choice(told):
    """Checks a style or a layout: an id, or a file as a dict."""
    if told is None or isinstance(told, (str, dict)):
        return told
    raise TypeError(f"a style or a layout is an id or a dict, not {type(told).__name__}")


def _whole(name, number):
    if number is None:
        return None
    # Also converts integers of numpy.
    number = number.__index__()
    if not 0 <= number < 1 << 32:
        raise Error(f"{name}: must be from 0 to 4294967295, not {number}")
    return number


def _plain(value):
    """Converts a number of numpy to a number of Python."""
    if hasattr(value, "__index__"):
        return value.__index__()
    if hasattr(value, "__float__"):
        return float(value)
    raise TypeError(f"{type(value).__name__} is not a supported type")
