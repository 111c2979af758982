# SPDX-License-Identifier: Apache-2.0
"""Pairs of pictures with known answers: what `alidade diff` must say of each, and (run as a program) what idiff and ImageMagick's compare say, as the
table of docs/diff.md."""
import pathlib
import struct
import subprocess
import sys
import tempfile

from pictures import changed, linear, noisy, of_channels, pfm_bytes, png_bytes, scene, write

NAN, INF = float("nan"), float("inf")


def put(picture, places, value):
    """The picture with the pixels at `places` replaced."""
    return changed(picture, lambda x, y, pixel: tuple(value for _ in pixel) if (x, y) in places else pixel)


def seam(picture, row, columns):
    return changed(picture, lambda x, y, pixel: tuple(min(v + 24 / 255, 1) for v in pixel) if y == row and x in columns else pixel)


def hidden(picture, color):
    """Transparent in a corner, where the colour cannot be seen."""
    return changed(picture, lambda x, y, pixel: (*color, 0.0) if x + y < 40 else (*pixel, 1.0))


def shifted(picture):
    return [[row[0], *row[:-1]] for row in picture]


def pairs():
    """Rows: (name, reference's bytes, test's bytes, words, verdict, cause). The files' names end by their kind, .png or .pfm."""
    base = scene()
    light = changed(base, lambda x, y, pixel: tuple(linear(v) for v in pixel))
    png, pfm = png_bytes(base), pfm_bytes(light)
    gray = changed(base, lambda x, y, pixel: pixel[:1])
    opaque = changed(base, lambda x, y, pixel: (*pixel, 1.0))
    half = changed(base, lambda x, y, pixel: (*pixel, 128 / 255 if x > 60 else 1.0))
    noise = png_bytes(noisy(base, 0.06, 1)), png_bytes(noisy(base, 0.06, 2))
    fine = changed(base, lambda x, y, pixel: tuple(round(v * 65535) / 65535 for v in pixel))
    one_up = changed(fine, lambda x, y, pixel: (pixel[0] + 1 / 65535, *pixel[1:]) if (x, y) == (50, 20) else pixel)
    return [
        ("the same bytes", png, png, [], "pass", ""),
        ("the same pixels, other bytes", png, png_bytes(base, level=1), [], "pass", ""),
        ("NaN in the test", pfm, pfm_bytes(put(light, {(7, 9)}, NAN)), ["--fail", "9"], "fail", "nan"),
        ("NaN in the reference", pfm_bytes(put(light, {(7, 9)}, NAN)), pfm, ["--fail", "9"], "fail", "nan"),
        ("the same NaN in both", pfm_bytes(put(light, {(7, 9)}, NAN)), pfm_bytes(put(light, {(7, 9)}, NAN)), [], "warn", "nan"),
        ("all NaN against all black", pfm_bytes(put(light, {(x, y) for x in range(96) for y in range(64)}, 0.0)),
         pfm_bytes(put(light, {(x, y) for x in range(96) for y in range(64)}, NAN)), ["--fail", "9"], "fail", "nan"),
        ("an infinity in the test", pfm, pfm_bytes(put(light, {(90, 60)}, INF)), ["--fail", "9"], "fail", "inf"),
        ("another size", png, png_bytes([row[:-1] for row in base]), [], "incomparable", "size"),
        ("another size, by the header alone", png, png_bytes([row[:-1] for row in base])[:60], [], "incomparable", "size"),
        ("another size of another format", b"P6 # made\n# twice\n 95 64 255 ", png, [], "incomparable", "size"),
        ("another size of a GIF", png, b"GIF89a" + struct.pack("<HH", 95, 64) + bytes(20), [], "incomparable", "size"),
        ("the same size, cut off", png, png[:60], [], "error", "file"),
        ("gray against colour", png, png_bytes(gray), [], "incomparable", "channels"),
        ("gray in one and in three channels", png_bytes(gray), png_bytes(changed(gray, lambda x, y, pixel: pixel * 3)), [], "pass", ""),
        ("alpha in one alone", png, png_bytes(half), [], "incomparable", "alpha"),
        ("alpha that is 1 everywhere", png, png_bytes(opaque), [], "pass", ""),
        ("another alpha", png_bytes(half), png_bytes(changed(half, lambda x, y, p: (*p[:3], 100 / 255 if x > 60 else 1.0))), [], "fail", "alpha"),
        ("other colours where alpha is 0", png_bytes(hidden(base, (1, 0, 0))), png_bytes(hidden(base, (0, 0, 1))), [], "pass", ""),
        ("16 bits of the same", png, png_bytes(base, 16), [], "pass", ""),
        ("one step of 65535", png_bytes(fine, 16), png_bytes(one_up, 16), [], "fail", "pixels"),
        ("linear floats of the same", png, pfm, [], "pass", ""),
        ("a PNG that says it is linear", png, png_bytes(light, 16, gamma=1.0), [], "pass", ""),
        ("linear values written as sRGB", png, png_bytes(light), ["--preset", "pov"], "fail", "encoding"),
        ("one pixel", png, png_bytes(put(base, {(50, 20)}, 1.0)), [], "fail", "pixels"),
        ("one pixel that is allowed", png, png_bytes(put(base, {(50, 20)}, 1.0)), ["--allowfailures", "1"], "pass", "pixels"),
        ("one seam", png, png_bytes(seam(base, 32, range(20, 67))), ["--require", "mae<0.01", "--require", "max_abs<0.05"], "fail", "seam"),
        ("shifted by one pixel", png, png_bytes(shifted(base)), ["--preset", "ci"], "fail", "shift"),
        ("a gamma slip", png, png_bytes(of_channels(base, lambda v: v ** 1.1)), ["--preset", "pov"], "fail", "gamma"),
        ("swapped channels", png, png_bytes(changed(base, lambda x, y, p: (p[2], p[1], p[0]))), ["--preset", "ci"], "fail", "channels"),
        ("upside down", png, png_bytes(base[::-1]), ["--preset", "ci"], "fail", "mirrored"),
        ("too bright", png, png_bytes(of_channels(base, lambda v: v * 1.08)), ["--preset", "ci"], "fail", "exposure"),
        ("a little more everywhere", png, png_bytes(of_channels(base, lambda v: v + 12 / 255)), ["--preset", "ci"], "fail", "offset"),
        ("noise by an exact rule", *noise, [], "fail", "noise"),
        ("noise by its own rule", *noise, ["--preset", "noise"], "pass", "noise"),
        ("noise that hides a bias", noise[0], png_bytes(noisy(base, 0.06, 2, 0.012)), ["--preset", "noise"], "fail", "noise"),
        ("a warning that is asked for", *noise, ["--fail", "0.5", "--warn", "0.01"], "warn", "noise"),
        ("no picture", png, b"not a picture", [], "error", "file"),
    ]


CODES = {"pass": 0, "warn": 1, "fail": 2, "incomparable": 3, "error": 4}


def files(folder, name, reference, test):
    """Both written below `folder`; the endings are what the bytes are."""
    def ending(data):
        return ".pfm" if data[:2] in (b"PF", b"Pf") else ".png"
    stem = name.replace(" ", "_").replace(",", "")
    return [write(pathlib.Path(folder) / f"{stem}_{side}{ending(data)}", data) for side, data in (("reference", reference), ("test", test))]


def table():
    """What others say, with the same thresholds where they have them."""
    meaning = {"idiff": {0: "pass", 1: "warn", 2: "fail", 3: "size", 4: "file"}, "compare": {0: "same", 1: "differs", 2: "error"}}
    lines = ["| pair | words | `alidade diff` | cause | `idiff` | ImageMagick `compare` |", "|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for name, reference, test, words, verdict, cause in pairs():
            paths = files(folder, name, reference, test)
            pixel_rules = [w.replace("--", "-") for w in words] if words and words[0] in ("--fail", "--allowfailures") else []
            pixel_rules += ["-fail", "0.016", "-failpercent", "1"] if words == ["--preset", "ci"] else []
            idiff = subprocess.run(["idiff", *pixel_rules, *paths], capture_output=True).returncode
            magick = subprocess.run(["compare", "-metric", "AE", *paths, "null:"], capture_output=True).returncode
            lines.append(f"| {name} | {'`' + ' '.join(words) + '`' if words else ''} | {verdict} | {cause} | {meaning['idiff'].get(idiff, idiff)} | "
                         f"{meaning['compare'].get(magick, magick)} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write(table())
