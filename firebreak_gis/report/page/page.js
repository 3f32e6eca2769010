"use strict";
(function () {
  const data = JSON.parse(document.getElementById("data").textContent);
  const features = new Map();
  // Of the map on paper: fits A4 and Letter upright.
  const SHEET = 670, SHEET_HEIGHT = 440;
  let map = null;
  let chosen = null;

  function element(tag, text, attributes) {
    const made = document.createElement(tag);
    if (text !== null) made.textContent = text;
    for (const [name, value] of Object.entries(attributes || {})) made.setAttribute(name, value);
    return made;
  }

  function legend(entries) {
    const list = element("ul", null, { class: "legend" });
    for (const [colour, text] of entries) {
      const item = element("li", null);
      const swatch = element("i", null, { "aria-hidden": "true" });
      swatch.style.background = colour;
      item.append(swatch, text);
      list.append(item);
    }
    return list;
  }

  function choose(number, move) {
    const layer = features.get(number);
    if (!layer) return;
    if (chosen) chosen.setStyle(chosen.plain);
    chosen = layer;
    layer.setStyle({ color: "#ffb000", weight: 6, fillOpacity: 0.5 });
    if (layer.bringToFront) layer.bringToFront();
    const card = document.getElementById("card");
    card.replaceChildren();
    Object.entries(layer.feature.properties.card).forEach(([name, value], k) => {
      if (k === 0) { card.append(element("b", name + " " + value)); return; }
      const part = element("span", name + " ");
      part.append(element("em", value));
      card.append(part);
    });
    for (const row of document.querySelectorAll("tr.chosen")) row.classList.remove("chosen");
    const button = document.querySelector('button.go[data-feature="' + number + '"]');
    if (button) button.closest("tr").classList.add("chosen");
    if (move) {
      map.fitBounds(layer.getBounds().pad(2), { maxZoom: 0 });
      document.getElementById("map").scrollIntoView({ block: "nearest" });
    }
  }

  function drawMap() {
    const [width, height] = data.size;
    const bounds = [[0, 0], [height, width]];
    map = L.map("map", {
      crs: L.CRS.Simple, minZoom: -9, maxZoom: 2, zoomSnap: 0.25, zoomAnimation: false, attributionControl: false,
      maxBounds: [[-height / 2, -width / 2], [1.5 * height, 1.5 * width]],
    });
    map.fitBounds(bounds);
    L.control.scale({ imperial: false }).addTo(map);
    const panel = document.getElementById("layers");
    const grounds = element("fieldset", null);
    grounds.append(element("legend", "Ground"));
    const over = element("fieldset", null);
    over.append(element("legend", "Layers"));
    const shown = new Map();
    const sides = {};
    let radio = null;
    panel.append(grounds, over);

    const slider = document.getElementById("slider");
    const line = element("div", null, { class: "divide", id: "divide" });
    map.getContainer().append(line);
    function divide() {
      const both = sides.before && sides.after && map.hasLayer(sides.before.image) && map.hasLayer(sides.after.image);
      document.getElementById("compare").hidden = !both;
      line.hidden = !both;
      for (const side of Object.values(sides)) side.pane.style.clipPath = "";
      if (!both) return;
      const size = map.getSize(), x = size.x * slider.value / 100;
      const corner = map.containerPointToLayerPoint([0, 0]), middle = corner.x + x;
      const far = corner.add(size);
      const box = (from, to) => "polygon(" + from + "px " + corner.y + "px," + to + "px " + corner.y + "px," + to + "px " + far.y + "px," + from + "px " + far.y + "px)";
      sides.before.pane.style.clipPath = box(corner.x, middle);
      sides.after.pane.style.clipPath = box(middle, far.x);
      line.style.left = x - 1 + "px";
    }

    data.pictures.forEach((picture, order) => {
      const pane = map.createPane("picture-" + picture.key);
      pane.style.zIndex = 210 + order;
      const image = L.imageOverlay(picture.image, bounds, { pane: "picture-" + picture.key, alt: picture.label, className: picture.key === "terrain" ? "" : "cells", opacity: picture.base ? 1 : 0.8 });
      shown.set(picture.key, image);
      if (picture.key === "before" || picture.key === "after") sides[picture.key] = { image, pane };
      const label = element("label", null);
      const input = element("input", null, { type: picture.base ? "radio" : "checkbox", name: picture.base ? "ground" : picture.key, id: "layer-" + picture.key });
      input.checked = picture.shown;
      label.append(input, " " + picture.label);
      const key = legend(picture.legend);
      (picture.base ? grounds : over).append(label, key);
      const follow = () => {
        if (picture.base && input.checked) {
          if (radio && radio !== image) map.removeLayer(radio);
          radio = image;
        }
        if (input.checked) map.addLayer(image); else map.removeLayer(image);
        for (const other of document.querySelectorAll('#layers input[type="radio"]')) {
          const list = other.parentElement.nextElementSibling;
          if (list) list.hidden = !other.checked;
        }
        if (!picture.base) key.hidden = !input.checked;
        divide();
      };
      input.addEventListener("change", follow);
      follow();
    });

    const thin = (group) => ({ compartments: 1, existing: 2 })[group.key] || 3.5;
    data.outlines.forEach((group) => {
      const many = group.features.length > 3000;
      const layer = L.geoJSON({ type: "FeatureCollection", features: group.features }, {
        renderer: many ? L.canvas({ tolerance: 5 }) : undefined,
        coordsToLatLng: (xy) => L.latLng(xy[1], xy[0]),
        style: (feature) => ({
          color: feature.properties.colour || group.colour, weight: thin(group),
          fillOpacity: group.key === "compartments" ? 0.06 : 0.6, fillColor: feature.properties.colour || group.colour,
        }),
        onEachFeature: (feature, part) => {
          part.plain = { color: feature.properties.colour || group.colour, weight: thin(group), fillOpacity: group.key === "compartments" ? 0.06 : 0.6 };
          features.set(feature.properties.number, part);
          part.on("click", (event) => { L.DomEvent.stopPropagation(event); choose(feature.properties.number, false); });
        },
      });
      const label = element("label", null);
      const input = element("input", null, { type: "checkbox", name: group.key, id: "layer-" + group.key });
      input.checked = group.shown;
      label.append(input, " " + group.label);
      const key = legend(group.legend);
      over.append(label, key);
      const follow = () => {
        if (input.checked) map.addLayer(layer); else map.removeLayer(layer);
        key.hidden = !input.checked;
      };
      input.addEventListener("change", follow);
      follow();
    });

    const place = L.control({ position: "bottomright" });
    place.onAdd = () => element("div", data.origin[2], { class: "place", id: "place" });
    place.addTo(map);
    map.on("mousemove", (event) => {
      const east = Math.round(data.origin[0] + event.latlng.lng), north = Math.round(data.origin[1] + event.latlng.lat);
      document.getElementById("place").textContent = "E " + east + "  N " + north + "  " + data.origin[2];
    });

    slider.addEventListener("input", divide);
    map.on("move zoom resize viewreset", divide);
    divide();
    // The sheet has another width than the window, and the map does not follow by itself.
    let seen = null;
    window.addEventListener("beforeprint", () => {
      seen = [map.getCenter(), map.getZoom()];
      map.getContainer().style.width = SHEET + "px";
      map.getContainer().style.height = SHEET_HEIGHT + "px";
      map.invalidateSize(false);
      map.fitBounds(bounds);
      divide();
    });
    window.addEventListener("afterprint", () => {
      map.getContainer().style.width = map.getContainer().style.height = "";
      map.invalidateSize(false);
      map.setView(...seen);
    });
  }

  function sortable(table) {
    const bodies = Array.from(table.tBodies);
    const groups = bodies.map((body) => Array.from(body.rows));
    const rows = groups.flat().filter((row) => !row.classList.contains("group"));
    const box = table.closest("section").querySelector("input.grouped");
    const heads = table.tHead.querySelectorAll("th");
    const unsort = () => { for (const other of heads) other.setAttribute("aria-sort", "none"); };

    function regroup(grouped) {
      for (const row of table.querySelectorAll("tr.group")) row.hidden = !grouped;
      bodies.forEach((body, k) => body.append(...groups[k]));
    }
    if (box) box.addEventListener("change", () => { unsort(); regroup(box.checked); });

    table.tHead.addEventListener("click", (event) => {
      const button = event.target.closest("button[data-column]");
      if (!button) return;
      const head = button.closest("th"), column = Number(button.dataset.column);
      const rising = head.getAttribute("aria-sort") !== "ascending";
      unsort();
      head.setAttribute("aria-sort", rising ? "ascending" : "descending");
      if (box) { box.checked = false; regroup(false); }
      const key = (row) => row.cells[column].dataset.key;
      const numeric = rows.every((row) => key(row) === "" || !Number.isNaN(Number(key(row))));
      const sorted = Array.from(rows).sort((a, b) => {
        const x = key(a), y = key(b);
        if (x === "" || y === "") return (x === "") - (y === "");
        const order = numeric ? Number(x) - Number(y) : x.localeCompare(y);
        return rising ? order : -order;
      });
      bodies[0].append(...sorted);
    });
    table.addEventListener("click", (event) => {
      const button = event.target.closest("button.go");
      if (button && map) choose(Number(button.dataset.feature), true);
    });
  }

  if (document.getElementById("map")) drawMap();
  for (const table of document.querySelectorAll("table.sortable")) sortable(table);
})();
