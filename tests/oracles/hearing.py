"""The onsets that librosa detects in a synthetic sound, for `tests/hearing.rs`, which makes the same sound.

    pip install librosa==0.11.0
    python tests/oracles/hearing.py

Writes `tests/oracles/data/hearing.json`: the strokes of the sound, and the onsets that librosa's
`onset_detect` finds by spectral flux, in seconds. Each stroke has its time, its loudness, its decay in
seconds and its tone in Hz (0 for noise).
"""

import json
import pathlib

import librosa
import numpy as np

DATA = pathlib.Path(__file__).parent / "data"
RATE = 16000
SECONDS = 14
# Both sides draw the same noise: a congruential generator (Numerical Recipes, section 7.1).
NOISE = np.empty(RATE * SECONDS)
STATE = 1
for i in range(len(NOISE)):
    STATE = (STATE * 1664525 + 1013904223) % 2**32
    NOISE[i] = STATE / 2**31 - 1


def strokes():
    """Irregular times, 0.31 to 0.95 s from each other."""
    second = 0.5
    for i in range(20):
        tone = [0, 0, 180, 900, 2600][i % 5]
        yield {
            "second": round(second, 4),
            "loudness": [0.8, 0.4, 0.6, 0.25][i % 4],
            "fading": [0.01, 0.06, 0.03][i % 3],
            "tone": tone,
        }
        second += 0.31 + 0.64 * ((i * 7) % 11) / 11


def main():
    told = list(strokes())
    sound = 0.002 * NOISE
    for stroke in told:
        first = round(stroke["second"] * RATE)
        t = np.arange(RATE // 2) / RATE
        wave = np.sin(2 * np.pi * stroke["tone"] * t) if stroke["tone"] else NOISE[: len(t)]
        sound[first : first + len(t)] += stroke["loudness"] * np.exp(-t / stroke["fading"]) * wave
    onsets = librosa.onset.onset_detect(y=sound, sr=RATE, hop_length=160, units="time")
    # It takes the beginning of the noise for an onset.
    onsets = onsets[onsets > 0.25]
    data = {"rate": RATE, "seconds": SECONDS, "strokes": told, "onsets": [round(float(t), 3) for t in onsets]}
    (DATA / "hearing.json").write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
