# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway report` writes one self-contained HTML page for a run or a sweep."""

import json
import re
import shlex
import shutil
import subprocess
from html.parser import HTMLParser

import pytest
from commands import reply
from host import ROOT, succeed
from raceway.cli import main
from raceway.rows import cells
from raceway.runs.run import Run
from raceway.runs.statics import statics
from raceway.runs.summary_table import TOPICS, shown

SCENE = {"passes": 1, "samples": 40, "models": "full", "load": 3e4, "clearance": 1e-5}
TABLE = """load,lubricant,passes,samples
1000,vg32,1,20
2000,dry,1,20
4000,vg32,1,20
1e9,dry,1,20
"""
# actions in a browser: zoom into the first chart, read a value, and choose another axis
ACTIONS = """
<script>
window.addEventListener("load", () => {
  const svg = document.querySelector("svg.chart"), at = svg.getBoundingClientRect();
  const lines = () => svg.querySelector("path[stroke], circle").outerHTML;
  const send = (type, x, y) => svg.dispatchEvent(new MouseEvent(type, {bubbles: true,
    clientX: at.left + x * at.width, clientY: at.top + y * at.height}));
  const whole = lines();
  send("mousedown", 0.3, 0.2); send("mousemove", 0.5, 0.8); send("mouseup", 0.5, 0.8);
  const zoomed = lines();
  send("dblclick", 0.5, 0.5);
  const menu = document.querySelectorAll("select")[1];
  let picked = "";
  if (menu) {
    menu.value = menu.options[menu.options.length - 1].value;
    menu.dispatchEvent(new Event("change"));
    picked = document.querySelector("svg.chart").textContent;
  }
  document.body.dataset.tried = JSON.stringify({
    zooms: zoomed !== whole, back: lines() === whole, picked: picked,
    read: document.querySelector(".read").textContent});
});
</script>
"""


class Parsed(HTMLParser):
    """The tags of a page with their attributes, the contents of its data scripts keyed by id, and
    its text."""

    def __init__(self, page):
        super().__init__()
        self.tags, self.data, self.text, self.inside = [], {}, "", None
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        self.inside = dict(attributes).get("id") if tag == "script" else tag

    def handle_data(self, data):
        if self.inside and self.inside.startswith("chart"):
            self.data[self.inside] = json.loads(data)
        else:
            self.text += data


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "a<b>&c"
    succeed("inputs/in.6208", out=folder.with_name("run"), lubricant="vg68", **SCENE)
    folder.with_name("run").rename(folder)  # the name contains characters that are special in HTML
    assert main(["report", str(folder)]) == 0
    return folder


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sweep")
    (folder / "table.csv").write_text(TABLE)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(ROOT)
        assert main(["sweep", str(folder / "table.csv"), "--out", str(folder / "all")]) == 1
        assert main(["report", str(folder / "all"), "--out", str(folder / "page.html")]) == 0
    return folder


def test_page_of_a_run(folder):
    text = (folder / "report.html").read_text()
    page, run = Parsed(text), Run(folder)
    figures = run.summary()
    others = statics(run.tables, figures)["statics"]
    assert others["friction_torque_N_m"] > 0
    for row in cells(shown(figures), TOPICS, others=others):
        for cell in row:
            assert cell in page.text
    assert figures["warnings"]  # a load of 30 kN causes a pressure of more than 4.2 GPa
    for warning in figures["warnings"]:
        assert warning in page.text
    load = next(c for c in page.data.values() if c["y"] == "kN" and len(c["lines"]) == 2)
    assert max(load["lines"][0]["values"]) == pytest.approx(
        1e-3 * figures["q_inner_max_N"], rel=1e-5
    )
    assert len(load["x"]["values"]) == len(load["lines"][0]["values"]) == 41
    assert [tag for tag, _ in page.tags].count("img") == 1
    assert len(page.data) >= 11
    losses = next(c for c in page.data.values() if len(c["lines"]) > 2)
    assert all(any(line["values"]) for line in losses["lines"])  # no line for a loss that is zero


def test_page_loads_nothing(folder, sweep):
    for path in (folder / "report.html", sweep / "page.html"):
        text = path.read_text()
        for tag, attributes in Parsed(text).tags:
            assert tag not in ("link", "iframe", "object")
            for name in ("src", "href"):
                assert attributes.get(name, "data:").startswith("data:"), (tag, attributes)
        assert not re.search(r"url\((?!#)|@import|fetch\(|XMLHttp|import\(", text)
        assert "default-src 'none'" in text and len(text) < 2e6


def test_command_repeats_the_run(folder, tmp_path):
    """The command shown on the page repeats the run, with bitwise identical loads."""
    text = Parsed((folder / "report.html").read_text()).text
    (command,) = re.findall(r"build/liggghts -in inputs/in.6208 .*", text)
    words = shlex.split(command)[3:]
    variables = dict(zip(words[1::3], words[2::3]))
    assert words[::3] == ["-var"] * len(variables)
    succeed("inputs/in.6208", out=tmp_path, **variables)
    assert Run(tmp_path).contacts["load"].equals(Run(folder).contacts["load"])


def test_page_of_a_sweep(sweep):
    page = Parsed((sweep / "page.html").read_text())
    assert "4 points, 3 finished" in page.text
    assert "bearing: load (N) is 1e+09" in page.text
    (chart,) = page.data.values()
    assert chart["table"]["load"] == [1000, 2000, 4000] and chart["x"] == "load"
    assert chart["table"]["capacitance_F"][1] is None  # the run is dry
    assert "raceway sweep TABLE.csv" in page.text
    lines = [sorted(line.split(",")) for line in page.text.splitlines()]
    for row in TABLE.replace("1e9", "1000000000").split():
        assert sorted(row.split(",")) in lines, row


def test_mistakes(tmp_path, capsys):
    assert "contains neither a run (run.yaml) nor a sweep" in reply(
        capsys, ["report", str(tmp_path)], code=1
    )


def test_record_without_contacts(tmp_path, capsys):
    succeed("inputs/in.6208", out=tmp_path, record="summary", passes=1, samples=20)
    assert main(["report", str(tmp_path)]) == 0
    text = (tmp_path / "report.html").read_text()
    assert "No picture of the contacts" in text and "largest contact load" in text


@pytest.mark.skipif(shutil.which("chromium") is None, reason="chromium is not installed")
def test_in_a_browser(folder, sweep, tmp_path):
    """Debian's Chromium draws the charts. Dragging a rectangle zooms in, a double click resets the
    zoom, moving the mouse shows values, and a menu selects the axis."""
    for number, path in enumerate((folder / "report.html", sweep / "page.html")):
        page = tmp_path / f"{number}.html"
        page.write_text(path.read_text().replace("</body>", ACTIONS + "</body>"))
        done = subprocess.run(
            [
                "chromium",
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--dump-dom",
                f"file://{page}",
            ],
            capture_output=True,
            text=True,
            timeout=120,
            check=True,
        )
        charts = len(Parsed(path.read_text()).data)
        dom = done.stdout
        assert dom.count('class="chart"') == charts
        assert dom.count("<path d=") + dom.count("<circle ") >= charts
        tried = json.loads(
            re.search(r'data-tried="([^"]*)"', dom)[1].replace("&quot;", '"').replace("&amp;", "&")
        )
        assert tried["zooms"]
        assert not re.search(r' (?:d|x|y|cx|cy|x1|y1|x2|y2)="[^"]*(?:NaN|Infinity)', dom)
        assert re.search(r": [0-9.e-]+", tried["read"]) or number == 1
        assert tried["back"] or number == 1  # the menu has redrawn the chart
        assert number == 0 or "wall_s" in tried["picked"] or "_" in tried["picked"]
