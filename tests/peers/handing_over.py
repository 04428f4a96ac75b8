"""What `report` writes, read by the parser of the HTML standard in its strict mode: any mistake ends it. And nothing in it leads outside."""

from pathlib import Path
from tempfile import TemporaryDirectory

import html5lib
from harness import BINARY, bench, expect, group, run

case = group("handing over")

LANGUAGES = {"English": ("en",), "German": ("de",)}
PROJECT = """[report]
customer = "<Müller> & 'Söhne' \\u202e"
[drives."<b>pump</b>"]
address = 1
"""
# What makes a browser load something.
LOADING = {"script", "link", "iframe", "object", "embed", "audio", "video", "source", "base", "form"}
NAMED = {"src", "href", "xlink:href", "srcset", "data", "action", "style"}


@case("a page in {} is valid, whole and loads nothing", each=LANGUAGES)
def _(lang):
    with TemporaryDirectory(prefix="antrieb-peers-") as directory, bench() as served:
        here = Path(directory)
        (here / "antrieb.toml").write_text(PROJECT)
        common = (BINARY, "--config", here / "antrieb.toml", "--port", served.port)
        run(*common, "-a", "1", "monitor", "283", "210", "--count", "5", "--interval", "0", "--record", here / "<i>.ndjson").exits(0)
        page = here / "page.html"
        files = (page, here / "page.md", "--record", here / "<i>.ndjson")
        run(*common, "-a", "1,7", "--lang", lang, "report", *files, "--count", "5").exits(9)
        tree = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(page.read_text())
    elements = [element for element in tree.iter() if isinstance(element.tag, str)]
    expect("language", tree.get("lang"), lang)
    expect("loading", [element.tag for element in elements if element.tag in LOADING], [])
    outside = [value for element in elements for name, value in element.items() if name in NAMED and not value.startswith("data:")]
    expect("outside", outside, [])
    expect("pictures", sum(element.tag.endswith("svg") for element in elements), 1)
    told = " ".join(tree.itertext())
    expect("names are names", ("<b>pump</b>" in told, "<Müller> & 'Söhne'" in told, "<i>.ndjson" in told), (True, True, True))
