"""No file leads to the network unless asked, and no file that an input is made of is overwritten."""

from __future__ import annotations

import contextlib
import socket
import threading
from pathlib import Path

import geopandas as gpd
import numpy as np
import pytest
import rasterio
from rasterio.transform import from_origin
from shapely.geometry import Point

from firebreak_gis.errors import InputError, OutputError, ParameterError
from firebreak_gis.files import require_writable
from firebreak_gis.landscape.amounts import value_at_risk
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.landscape.planes import ignition_source
from firebreak_gis.rasters import files_behind, read_raster
from firebreak_gis.vectors import read_features, read_points, read_polygons

UTM = "EPSG:32633"
TRANSFORM = from_origin(500000, 4500000, 20, 20)


class Server:
    """Listens on this machine and counts who comes."""

    def __init__(self):
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.address = f"http://127.0.0.1:{self.socket.getsockname()[1]}"
        self.visits = 0
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        while True:
            try:
                visitor, _ = self.socket.accept()
            except OSError:
                return
            self.visits += 1
            with contextlib.suppress(OSError), visitor:
                visitor.recv(4096)
                visitor.sendall(b"HTTP/1.0 404 Not Found\r\nContent-Length: 0\r\n\r\n")


@pytest.fixture(params=["", "*"], ids=["proxy", "no_proxy"])
def server(request, monkeypatch):
    monkeypatch.setenv("NO_PROXY", request.param)  # a proxy is no wall where the user's variables go round it
    monkeypatch.setenv("no_proxy", request.param)
    found = Server()
    with found.socket:
        yield found


def virtual(source, *, element="SourceFilename", relative=0):
    return (
        f'<VRTDataset rasterXSize="12" rasterYSize="10"><SRS>{UTM}</SRS>'
        "<GeoTransform>500000, 20, 0, 4500000, 0, -20</GeoTransform>"
        '<VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
        f'<{element} relativeToVRT="{relative}">{source}</{element}><SourceBand>1</SourceBand>'
        "</SimpleSource></VRTRasterBand></VRTDataset>"
    )


def wms(address):
    window = {
        "UpperLeftX": 500000,
        "UpperLeftY": 4500000,
        "LowerRightX": 5.002e5,
        "LowerRightY": 4499800,
        "TileLevel": 0,
    }
    return (
        f'<GDAL_WMS><Service name="TMS"><ServerUrl>{address}/${{z}}</ServerUrl></Service><DataWindow>'
        + "".join(f"<{name}>{value}</{name}>" for name, value in window.items())
        + "</DataWindow><Projection>EPSG:32633</Projection><BlockSizeX>10</BlockSizeX><BlockSizeY>10</BlockSizeY>"
        "<BandsCount>1</BandsCount></GDAL_WMS>"
    )


def rasters_that_lead_out(folder, address):
    there = f"{address}/a.tif"
    files = {
        "wms.xml": wms(address),
        "wms.tif": wms(address),
        "wcs.xml": f"<WCS_GDAL><ServiceURL>{address}/?</ServiceURL><CoverageName>x</CoverageName></WCS_GDAL>",
        "plain.vrt": virtual(f"/vsicurl/{there}"),
        "address.vrt": virtual(there),
        "streaming.vrt": virtual(f"/vsicurl_streaming/{there}"),
        "cdata.vrt": virtual(f"<![CDATA[/vsicurl/{there}]]>"),
        "entities.vrt": virtual("&#47;vsi&#99;url/" + there.replace("http", "&#104;ttp")),
        "capitals.vrt": virtual(f"/vsicurl/{there}", element="SOURCEFILENAME"),
        "nested.vrt": virtual("cdata.vrt", relative=1),
        "to_wms.vrt": virtual(folder / "wms.xml"),
        "inline.vrt": virtual(wms(address).replace("<", "&lt;").replace(">", "&gt;")),
        "vrt.tif": virtual(f"/vsicurl/{there}"),
        "vrt": virtual(f"/vsicurl/{there}"),
    }
    for name, text in files.items():
        (folder / name).write_text(text)
    return [
        there,
        f"/vsicurl/{there}",
        f"/vsicurl_streaming/{there}",
        f"/vsizip/vsicurl/{there}",
        f"WMTS:{address}/capabilities.xml",
        f"WCS:{address}/?coverage=a",
        f'NETCDF:"{there}":a',
        f"vrt:///vsicurl/{there}",
        wms(address),
        virtual(f"/vsicurl/{there}"),
        *(str(folder / name) for name in files),
    ]


def vectors_that_lead_out(folder, address):
    there = f"{address}/a.geojson"

    def pointing(source, relative=0):
        return (
            '<OGRVRTDataSource><OGRVRTLayer name="a">'
            f'<SrcDataSource relativeToVRT="{relative}">{source}</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>'
        )

    files = {
        "plain.vrt": pointing(there),
        "cdata.vrt": pointing(f"<![CDATA[/vsicurl/{there}]]>"),
        "capitals.vrt": pointing(there).replace("SrcDataSource", "SRCDATASOURCE"),
        "nested.vrt": pointing("cdata.vrt", relative=1),
        "wfs.xml": f"<OGRWFSDataSource><URL>{address}/wfs</URL></OGRWFSDataSource>",
        "to_wfs.vrt": pointing("wfs.xml", relative=1),
        "vrt.gpkg": pointing(there),
    }
    for name, text in files.items():
        (folder / name).write_text(text)
    names = [there, f"/vsicurl/{there}", f"WFS:{address}/wfs", f"OAPIF:{address}", pointing(there)]
    return [*names, *(str(folder / name) for name in files)]


def test_no_raster_reaches_the_network(tmp_path, server):
    for name in rasters_that_lead_out(tmp_path, server.address):
        with pytest.raises(InputError):
            read_raster(name)
        assert server.visits == 0, name


def test_with_leave_the_network_is_reached(tmp_path, server):
    for name in (f"/vsicurl/{server.address}/allowed.tif", tmp_path / "wms.xml"):
        before = server.visits
        rasters_that_lead_out(tmp_path, server.address)
        with pytest.raises(InputError):  # there is nothing to be read
            read_raster(name, remote=True)
        assert server.visits > before, name


def test_no_vector_reaches_the_network(tmp_path, server):
    for name in vectors_that_lead_out(tmp_path, server.address):
        for read in (read_points, read_polygons, read_features):
            with pytest.raises(InputError):
                read(name, UTM)
        assert server.visits == 0, name


def test_a_schema_on_a_server_is_not_fetched(tmp_path, server):
    place = tmp_path / "points.gml"
    place.write_text(
        '<?xml version="1.0"?><w:FeatureCollection xmlns:w="http://www.opengis.net/wfs" '
        'xmlns:gml="http://www.opengis.net/gml" xmlns:a="http://a" '
        'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
        f'xsi:schemaLocation="http://a {server.address}/wfs?service=WFS&amp;version=1.0.0&amp;'
        'request=DescribeFeatureType&amp;typeName=a:b"><gml:featureMember><a:b><a:g><gml:Point srsName="EPSG:4326">'
        "<gml:coordinates>15,40</gml:coordinates></gml:Point></a:g></a:b></gml:featureMember></w:FeatureCollection>"
    )
    assert len(read_points(place, UTM)) == 1
    assert server.visits == 0


def test_no_layer_of_the_planner_reaches_the_network(tmp_path, server):
    from firebreak_gis.grid import Grid

    grid = Grid((10, 12), TRANSFORM, rasterio.CRS.from_epsg(32633).to_wkt())
    (tmp_path / "v").mkdir()
    names = [
        *rasters_that_lead_out(tmp_path, server.address),
        *vectors_that_lead_out(tmp_path / "v", server.address),
    ]
    for name in names:
        for read in (
            lambda source: ignition_source(source, grid),
            lambda source: mask_plane(source, grid, what="barriers", rule="touched"),
            lambda source: value_at_risk(source, grid, field="people"),
        ):
            # Points are handed on unread, and a raster has no column.
            with contextlib.suppress(InputError, ParameterError):
                read(name)
        assert server.visits == 0, name


def raster(path):
    with rasterio.open(
        path, "w", driver="GTiff", height=10, width=12, count=1, dtype="uint8", crs=UTM, transform=TRANSFORM
    ) as target:
        target.write(np.arange(120, dtype=np.uint8).reshape(1, 10, 12))
    return path


def test_virtual_files_on_this_machine_are_read(tmp_path):
    raster(tmp_path / "a.tif")
    for name, source in {"one.vrt": "<![CDATA[a.tif]]>", "two.vrt": "one.vrt"}.items():
        (tmp_path / name).write_text(virtual(source, relative=1))
        assert read_raster(tmp_path / name).to_numpy().sum() == np.arange(120).sum()
    gpd.GeoDataFrame(geometry=[Point(500100, 4499900)], crs=UTM).to_file(tmp_path / "p.gpkg")
    (tmp_path / "p.vrt").write_text(
        '<OGRVRTDataSource><OGRVRTLayer name="p"><SrcDataSource relativeToVRT="1">p.gpkg</SrcDataSource></OGRVRTLayer>'
        "</OGRVRTDataSource>"
    )
    assert len(read_points(tmp_path / "p.vrt", UTM)) == 1


@pytest.mark.parametrize(
    "text",
    [
        virtual("part.tif", relative=1),
        virtual("<![CDATA[part.tif]]>", relative=1),
        virtual("part.tif", relative=1, element="sourcefilename"),
        virtual("pa&#114;t.tif", relative=1),
        virtual("inner.vrt", relative=1),
        "<OGRVRTDataSource><OGRVRTLayer><srcdatasource>FOLDER/part.tif</srcdatasource></OGRVRTLayer></OGRVRTDataSource>",
        "<OGRVRTDataSource><SrcDataSource><![CDATA[part.tif]]></SrcDataSource></OGRVRTDataSource>",
    ],
    ids=["plain", "cdata", "lower case", "entity", "nested", "vector", "vector cdata"],
)
def test_what_a_virtual_file_is_made_of_is_an_input(tmp_path, text):
    part = raster(tmp_path / "part.tif")
    (tmp_path / "inner.vrt").write_text(virtual("<![CDATA[part.tif]]>", relative=1))
    (tmp_path / "outer.vrt").write_text(text.replace("FOLDER", str(tmp_path)))
    (tmp_path / "alias.tif").symlink_to(part)
    behind = files_behind([tmp_path / "outer.vrt"])
    assert str(part) in behind
    for target in (part, tmp_path / "alias.tif"):
        with pytest.raises(OutputError, match="is the input"):
            require_writable(target, overwrite=True, forbid=behind)


def test_a_ring_of_virtual_rasters_is_refused(tmp_path):
    for one, other in (("a.vrt", "b.vrt"), ("b.vrt", "a.vrt")):
        (tmp_path / one).write_text(virtual(other, relative=1))
    assert sorted(Path(name).name for name in files_behind([tmp_path / "a.vrt"])) == ["a.vrt", "b.vrt"]
    with contextlib.suppress(InputError):  # GDAL reads it as empty or refuses it; it ends
        read_raster(tmp_path / "a.vrt")
