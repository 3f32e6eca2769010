"""The report page in a real Chromium, without a window and without a network.

python -m pytest tests/browser -n 0        needs `pip install selenium` and the packages of apt-packages.txt
"""

from __future__ import annotations

import functools
import http.server
import shutil
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from firebreak_gis.report.page import render
from firebreak_gis.report.page.plan import plan_page

SIZE = (1300, 1000)


@pytest.fixture(scope="module")
def folder(tmp_path_factory, small_plan_parts) -> Path:
    place = tmp_path_factory.mktemp("page")
    account = {"assumptions": ["Breaks are perfect."], "files": [("breaks.tif", "Fire breaks")], "warnings": ["Look."]}
    (place / "report.html").write_text(render(plan_page(small_plan_parts, account)), encoding="utf-8")
    return place


@pytest.fixture(scope="module")
def small_plan_parts():
    """A small plan as its folder holds it."""
    from firebreak_gis.evaluation.curves import table
    from firebreak_gis.planning.pipeline import plan
    from tests.conftest import _landscape

    result = plan(_landscape((40, 60), seed=3, holes=0.05), budget=0.1, n_runs=20, method="dissection")
    landscape = {f"{name}.tif": result.landscape[name] for name in ("elevation", "vegetation", "density")}
    return landscape | {
        "breaks.tif": result.breaks,
        "burn_frequency.tif": result.before["burn_frequency"],
        "burn_frequency_with_breaks.tif": result.after["burn_frequency"],
        "segments.gpkg": result.segments[1],
        "compartments.gpkg": result.compartments,
        "evaluation.csv": table(result.evaluation),
    }


class Noted(http.server.SimpleHTTPRequestHandler):
    """Serves a folder on this machine and notes what is asked for."""

    asked: list[str] = []  # noqa: RUF012 - the server makes an object a request

    def do_GET(self):
        Noted.asked.append(self.path)
        super().do_GET()

    def log_message(self, *_):
        pass


def browser(*more: str):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium") or "chromium"
    # The sandbox of the browser needs rights that a container lacks; every name but this machine's is unknown.
    for word in (
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        *more,
        f"--window-size={SIZE[0]},{SIZE[1]}",
        "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1",
    ):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))


@pytest.fixture(scope="module")
def driver():
    found = browser()
    yield found
    found.quit()


@pytest.fixture
def page(driver, folder):
    driver.get((folder / "report.html").as_uri())
    WebDriverWait(driver, 10).until(lambda d: d.find_elements(By.CSS_SELECTOR, ".leaflet-image-layer"))
    yield driver
    assert [entry for entry in driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")] == []


def test_it_renders(page):
    assert page.title.startswith("Fire breaks by dissection")
    images = page.find_elements(By.CSS_SELECTOR, "img.leaflet-image-layer")
    assert len(images) == 3  # the ground and both sides
    assert all(page.execute_script("return arguments[0].naturalWidth", image) == 60 for image in images)
    paths = page.find_elements(By.CSS_SELECTOR, "path.leaflet-interactive")
    assert len(paths) == len(page.find_elements(By.CSS_SELECTOR, "#segments tbody tr:not(.group)"))
    assert "Breaks are perfect." in page.find_element(By.CSS_SELECTOR, ".assumptions").text


def test_the_slider_moves_the_line_between_before_and_after(page):
    slider, line = page.find_element(By.ID, "slider"), page.find_element(By.ID, "divide")
    edges = []
    for key in (None, Keys.HOME, Keys.END):
        if key:
            slider.send_keys(key)
        clip = page.execute_script("return document.querySelector('.leaflet-picture-before-pane').style.clipPath")
        edges.append((line.location["x"], clip))
    middle, left, right = edges
    assert left[0] < middle[0] < right[0]
    assert len({clip for _, clip in edges}) == 3


def test_a_click_on_the_map_opens_the_card_and_marks_the_row(page):
    """The middle of a segment's outline is clicked, not the element."""
    card = page.find_element(By.ID, "card")
    assert card.text.startswith("Choose")
    page.execute_script("document.getElementById('map').scrollIntoView()")
    boxes = [p.rect for p in page.find_elements(By.CSS_SELECTOR, "path.leaflet-interactive")]
    box = max(boxes, key=lambda b: b["width"] * b["height"])
    where = page.find_element(By.ID, "map")
    x = box["x"] + box["width"] / 2 - where.rect["x"] - where.rect["width"] / 2
    y = box["y"] + box["height"] / 2 - where.rect["y"] - where.rect["height"] / 2
    ActionChains(page).move_to_element_with_offset(where, int(x), int(y)).click().perform()
    if card.text.startswith("Choose"):  # the box of a bent wall may be empty in its middle
        page.find_elements(By.CSS_SELECTOR, "button.go")[0].click()
    assert card.text.startswith("Segment")
    assert len(page.find_elements(By.CSS_SELECTOR, "tr.chosen")) == 1


def test_a_row_leads_to_its_segment_by_keyboard(page):
    button = page.find_elements(By.CSS_SELECTOR, "button.go")[2]
    number = button.text
    page.execute_script("arguments[0].focus()", button)
    button.send_keys(Keys.ENTER)
    assert page.find_element(By.ID, "card").text.startswith(f"Segment {number}")


def test_columns_sort(page):
    head = page.find_elements(By.CSS_SELECTOR, "#segments th")[4]
    for order, sign in (("ascending", 1), ("descending", -1)):
        head.find_element(By.TAG_NAME, "button").send_keys(Keys.ENTER)
        assert head.get_attribute("aria-sort") == order
        cells = page.find_elements(By.CSS_SELECTOR, "#segments tbody td:nth-child(5)")
        values = [float(c.get_attribute("data-key") or "nan") for c in cells]
        known = sign * np.array([v for v in values if v == v])
        assert (np.diff(known) >= 0).all()


def test_segments_stand_in_groups_until_a_column_is_sorted(page):
    """By stage, each with its sums; sorting takes all rows together, and the box brings the groups back."""
    box = page.find_element(By.CSS_SELECTOR, "input.grouped")
    if not box.is_selected():
        box.click()

    def lines():
        rows = page.find_elements(By.CSS_SELECTOR, "#segments tbody tr")
        return [row for row in rows if row.is_displayed()]

    def stages():
        return [
            row.find_elements(By.TAG_NAME, "td")[1].text for row in lines() if "group" not in row.get_attribute("class")
        ]

    grouped = stages()
    heads = [row.text for row in lines() if "group" in row.get_attribute("class")]
    assert [head.split()[1] for head in heads] == list(dict.fromkeys(grouped))
    assert grouped == sorted(grouped, key=int)
    page.find_elements(By.CSS_SELECTOR, "#segments th[aria-sort] button")[2].send_keys(Keys.ENTER)
    assert not box.is_selected()
    assert len(lines()) == len(grouped)
    box.click()
    assert stages() == grouped
    assert len(lines()) == len(grouped) + len(heads)


def test_layers_switch(page):
    box = page.find_element(By.ID, "layer-after")
    box.click()
    assert not page.find_element(By.ID, "compare").is_displayed()
    assert len(page.find_elements(By.CSS_SELECTOR, "img.leaflet-image-layer")) == 2
    box.click()
    assert page.find_element(By.ID, "compare").is_displayed()
    page.find_element(By.ID, "layer-vegetation").click()
    names = [i.get_attribute("alt") for i in page.find_elements(By.CSS_SELECTOR, "img.leaflet-image-layer")]
    assert "Vegetation type" in names
    assert "Terrain shade" not in names
    before = len(page.find_elements(By.CSS_SELECTOR, "path.leaflet-interactive"))
    page.find_element(By.ID, "layer-compartments").click()
    assert len(page.find_elements(By.CSS_SELECTOR, "path.leaflet-interactive")) > before


def test_no_request_leaves_the_page(driver, folder):
    handler = functools.partial(Noted, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        driver.get_log("performance")
        driver.get(f"http://127.0.0.1:{server.server_port}/report.html")
        WebDriverWait(driver, 10).until(lambda d: d.find_elements(By.CSS_SELECTOR, ".leaflet-image-layer"))
        driver.find_elements(By.CSS_SELECTOR, "button.go")[0].click()
        server.shutdown()
    assert Noted.asked == ["/report.html"]
    sent = [e["message"] for e in driver.get_log("performance") if '"Network.requestWillBeSent"' in e["message"]]
    assert sent
    assert not [m for m in sent if '"url":"http' in m and "127.0.0.1" not in m]


def test_dark_and_print(folder):
    dark = browser("--blink-settings=preferredColorScheme=0")
    try:
        dark.get((folder / "report.html").as_uri())
        colour = dark.execute_script("return getComputedStyle(document.body).backgroundColor")
        assert max(int(part) for part in colour.removeprefix("rgb(").removesuffix(")").split(",")) < 60
        pdf = dark.print_page()
        assert len(pdf) > 20_000
    finally:
        dark.quit()


def test_paper_shows_the_whole_map(driver, folder):
    """On paper the map has a width of its own; afterwards it is as it was."""
    driver.get((folder / "report.html").as_uri())
    where = """const box = e => { const r = e.getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; };
        return [box(document.getElementById("map")), box(document.querySelector(".leaflet-image-layer"))]"""
    before = driver.execute_script(where)
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    driver.execute_cdp_cmd(
        "Emulation.setDeviceMetricsOverride", {"width": 720, "height": 1000, "deviceScaleFactor": 1, "mobile": False}
    )
    try:
        driver.execute_script("window.dispatchEvent(new Event('beforeprint'))")
        frame, picture = driver.execute_script(where)
        assert frame[0] >= 0
        assert frame[2] <= 720
        assert picture[0] >= frame[0] - 1
        assert picture[1] >= frame[1] - 1
        assert picture[2] <= frame[2] + 1
        assert picture[3] <= frame[3] + 1
        # It fills the sheet in one way at least.
        share = max(
            (picture[2] - picture[0]) / (frame[2] - frame[0]), (picture[3] - picture[1]) / (frame[3] - frame[1])
        )
        assert share > 0.8
        shown = driver.execute_script(
            "return [...document.querySelectorAll('.panel label')].filter(e => e.offsetParent)"
            ".map(e => e.innerText.trim())"
        )
        assert "Terrain shade" in shown
        assert "Elevation [m]" not in shown
        assert "Compartments" not in shown
    finally:
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        driver.execute_script("window.dispatchEvent(new Event('afterprint'))")
    until = time.monotonic() + 10.0  # the page is laid out anew when it has time
    while (after := driver.execute_script(where))[1] != pytest.approx(before[1], abs=1.5):
        assert time.monotonic() < until, (after[1], before[1])
        time.sleep(0.1)


def test_the_legend_of_the_stages_has_the_colours_of_the_segments(driver, folder):
    driver.get((folder / "report.html").as_uri())
    swatches = driver.execute_script(
        "return [...document.querySelectorAll('#layers ul')].at(-1).innerText.trim().split('\\n').length"
    )
    told = driver.execute_script(
        "return JSON.parse(document.getElementById('data').textContent).outlines.find(o => o.key === 'segments')"
    )
    assert {f["properties"]["colour"] for f in told["features"]} == {colour for colour, _ in told["legend"]}
    assert swatches == len(told["legend"])
