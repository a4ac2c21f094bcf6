"""Stylising one image: shapes, types, randomness and errors."""

import inkpanel
import numpy as np
import pytest
from conftest import made_up


@pytest.mark.parametrize("style", ["comic", "noir", "gouache"])
def test_colour_in_gives_colour_of_the_same_size(style):
    drawn = inkpanel.stylize(made_up(1, 50, 71), style)
    assert (drawn.dtype, drawn.shape) == (np.uint8, (50, 71, 3))
    assert drawn.flags.c_contiguous and drawn.flags.writeable


def test_gray_in_gives_gray_or_colour():
    gray = made_up(2)[..., 0]
    shapes = {style["id"]: inkpanel.stylize(gray, style).shape for style in inkpanel.styles()[:12]}
    assert set(shapes.values()) <= {(90, 120), (90, 120, 3)}
    # A style with only ink gives a gray result. A gray picture with three channels gives the same.
    style = {"background": [{"block": "to_gray"}, {"block": "posterize", "levels": 4}]}
    drawn = inkpanel.stylize(gray, style)
    assert drawn.shape == (90, 120)
    three = inkpanel.stylize(np.repeat(gray[..., None], 3, axis=2), style)
    np.testing.assert_array_equal(np.repeat(drawn[..., None], 3, axis=2), three)
    printed = inkpanel.stylize(gray, {"background": [{"block": "hue", "red": 90}]})
    assert printed.shape == (90, 120, 3)


def test_pixels_are_as_computed():
    """Gain 2 with clamping, computed manually."""
    picture = made_up(3)
    drawn = inkpanel.stylize(picture, {"background": [{"block": "brightness", "gain": 2, "channels": "each"}]})
    expected = np.minimum(picture.astype(int) * 2, 255)
    assert np.abs(drawn.astype(int) - expected).max() <= 1


def test_strides_do_not_matter():
    picture = made_up(4)
    whole = inkpanel.stylize(picture, "comic")
    wide = np.zeros((90, 240, 3), np.uint8)
    wide[:, ::2] = picture
    for view in [np.asfortranarray(picture), wide[:, ::2], picture[::-1][::-1], np.ma.array(picture).data]:
        np.testing.assert_array_equal(inkpanel.stylize(view, "comic"), whole)
    np.testing.assert_array_equal(inkpanel.stylize(picture[:, ::-1], "comic"), inkpanel.stylize(picture[:, ::-1].copy(), "comic"))
    frozen = picture.copy()
    frozen.setflags(write=False)
    np.testing.assert_array_equal(inkpanel.stylize(frozen, "comic"), whole)
    np.testing.assert_array_equal(inkpanel.stylize(np.asfortranarray(picture[..., 0]), "comic"), inkpanel.stylize(picture[..., 0].copy(), "comic"))


def test_what_is_given_stays_as_it_is():
    picture = made_up(5)
    before = picture.copy()
    inkpanel.stylize(picture, "noir")
    np.testing.assert_array_equal(picture, before)


def test_a_seed_moves_what_is_left_to_chance():
    picture = made_up(6, 200, 200)
    drawn = [inkpanel.stylize(picture, "carnival", seed=seed) for seed in (1, 1, np.int64(2))]
    np.testing.assert_array_equal(drawn[0], drawn[1])
    assert (drawn[0] != drawn[2]).any()
    # The seed has no effect on a style without randomness.
    plain = {"background": [{"block": "posterize"}]}
    np.testing.assert_array_equal(inkpanel.stylize(picture, plain, seed=9), inkpanel.stylize(picture, plain))


@pytest.mark.parametrize(
    "array, says",
    [
        (np.zeros((4, 4, 3), np.float32), "float32"),
        (np.zeros((4, 4, 3), np.int8), "int8"),
        (np.zeros((4, 4, 3), ">u2"), "uint8"),
        (np.zeros((4, 4), bool), "bool"),
        (np.zeros((4, 4, 4), np.uint8), "alpha"),
        (np.zeros((4, 4, 2), np.uint8), "(4, 4, 2)"),
        (np.zeros(4, np.uint8), "(height, width, 3)"),
        (np.zeros((1, 4, 4, 3), np.uint8), "(1, 4, 4, 3)"),
        (np.ones((), np.uint8), "(height, width, 3)"),
    ],
)
def test_other_arrays_are_refused_with_what_they_are(array, says):
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.stylize(array, "comic")
    assert error.value.code == "invalid-array" and says in str(error.value)
    assert isinstance(error.value, ValueError)


@pytest.mark.parametrize("shape", [(0, 4, 3), (4, 0, 3), (0, 0), (4, 0)])
def test_no_pixels_are_refused(shape):
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.stylize(np.zeros(shape, np.uint8), "comic")
    assert error.value.code == "damaged"


def test_too_many_pixels_are_refused_before_memory_is_taken():
    huge = np.broadcast_to(np.zeros((1, 1, 3), np.uint8), (40_000, 40_000, 3))
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.stylize(huge, "comic")
    assert error.value.code == "too-large"


@pytest.mark.parametrize("nothing", [None, [[1, 2]], "a.jpg", 7])
def test_what_is_no_array_is_a_type_error(nothing):
    with pytest.raises(TypeError, match="numpy array"):
        inkpanel.stylize(nothing, "comic")


@pytest.mark.parametrize(
    "style, code, says",
    [
        ("no-such", "unknown-style", "no-such"),
        ({}, "invalid-style", "background"),
        ({"background": [{"block": "blur"}]}, "invalid-style", "blur"),
        ({"background": [{"block": "gaussian", "sigma": "x"}]}, "invalid-style", "sigma"),
    ],
)
def test_styles_that_are_none_are_named(style, code, says):
    with pytest.raises(inkpanel.Error) as error:
        inkpanel.stylize(made_up(7), style)
    assert error.value.code == code and says in str(error.value)


@pytest.mark.parametrize("style", [None, 3, ["comic"]])
def test_a_style_is_an_id_or_a_dict(style):
    with pytest.raises((TypeError, inkpanel.Error)):
        inkpanel.stylize(made_up(7), style)


@pytest.mark.parametrize("seed", [-1, 1 << 32])
def test_seeds_have_a_range(seed):
    with pytest.raises(inkpanel.Error, match="seed"):
        inkpanel.stylize(made_up(7), "comic", seed=seed)
