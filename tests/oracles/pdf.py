"""Reads an exported PDF file with pikepdf (PyPI, contains qpdf), and checks its syntax, structure, boxes and
metadata.

    pip install pikepdf==10.18.0
    python tests/oracles/pdf.py FILE.pdf ...

Prints the findings of each file. Exit code 1 if there is an error.
"""

import sys

import pikepdf


def elements(node):
    """All structure elements below a node, in their order."""
    kids = node.get("/K", [])
    kids = kids if isinstance(kids, pikepdf.Array) else [kids]
    for kid in kids:
        if isinstance(kid, pikepdf.Dictionary) and "/S" in kid:
            yield kid
            yield from elements(kid)


def faults(path):
    with pikepdf.open(path) as pdf:
        found = [str(problem) for problem in pdf.check_pdf_syntax()]
        root = pdf.Root
        tagged = list(elements(root.StructTreeRoot))
        names = [str(element.S) for element in tagged]
        print(path, len(pdf.pages), "sheets;", ", ".join(f"{names.count(name)} {name}" for name in sorted(set(names))))
        if not root.MarkInfo.Marked or names[:1] != ["/Document"]:
            found.append("is not tagged from the document on")
        found += ["a figure says nothing" for e in tagged if e.S == "/Figure" and not str(e.get("/Alt", ""))]
        found += ["a paragraph has no text" for e in tagged if e.S == "/P" and not str(e.get("/ActualText", ""))]
        parents = root.StructTreeRoot.ParentTree.Nums
        for index, page in enumerate(pdf.pages):
            marked = [
                (int(operands[1].MCID), str(operands[0]))
                for operands, operator in pikepdf.parse_content_stream(page)
                if str(operator) == "BDC" and "/MCID" in operands[1]
            ]
            listed = parents[2 * list(parents)[::2].index(page.StructParents) + 1]
            if len(marked) != len(listed) or any(str(listed[number].S) != tag for number, tag in marked):
                found.append(f"sheet {index + 1}: marks and structure do not agree")
            media, trim = page.MediaBox, page.TrimBox
            bleed = page.get("/BleedBox", trim)
            inside = all(
                media[i] <= bleed[i] <= trim[i] and trim[i + 2] <= bleed[i + 2] <= media[i + 2] for i in (0, 1)
            )
            if not inside:
                found.append(f"sheet {index + 1}: boxes do not lie in each other")
        with pdf.open_metadata() as about:
            if about.get("dc:title") != str(pdf.docinfo.get("/Title", "")):
                found.append("XMP and Info tell different titles")
            if any(key in about for key in ("xmp:CreateDate", "xmp:ModifyDate")) or "/CreationDate" in pdf.docinfo:
                found.append("says when it was made")
        colored = any("/DeviceRGB" in str(image.ColorSpace) for p in pdf.pages for image in p.get_images().values())
        if colored and b"acsp" not in root.OutputIntents[0].DestOutputProfile.read_bytes()[:128]:
            found.append("colours are of no space")
    return found


def main():
    wrong = 0
    for path in sys.argv[1:]:
        for fault in faults(path):
            print(f"{path}: {fault}", file=sys.stderr)
            wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main())
