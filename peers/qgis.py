"""QGIS opens the rasters as layers: heights, place on the earth, classes, a shaded picture; and
assets.csv as points."""
# debian: python3-qgis
# site: system

import os

os.environ["QT_QPA_PLATFORM"] = "offscreen"

from qgis.core import (Qgis, QgsApplication, QgsCoordinateReferenceSystem,  # noqa: E402
                       QgsCoordinateTransform, QgsHillshadeRenderer, QgsMapRendererParallelJob,
                       QgsMapSettings, QgsPointXY, QgsProject, QgsRasterBandStats,
                       QgsRasterLayer, QgsVectorLayer)
from qgis.PyQt.QtCore import QSize  # noqa: E402

from ground import Ground  # noqa: E402
from peer import WORLDS, Peer, assets, export  # noqa: E402


def to_degrees(crs):
    return QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem("EPSG:4326"),
                                  QgsProject.instance())


def shaded(layer):
    """How many grey values a shaded picture of a layer has."""
    layer.setRenderer(QgsHillshadeRenderer(layer.dataProvider(), 1, 315.0, 45.0))
    settings = QgsMapSettings()
    settings.setLayers([layer])
    settings.setDestinationCrs(layer.crs())
    settings.setExtent(layer.extent())
    settings.setOutputSize(QSize(256, 256))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    picture = job.renderedImage()
    return len({picture.pixel(x, y) & 0xFF for x in range(0, 256, 2) for y in range(0, 256, 2)})


def check_elevation(peer, folder, ground):
    layer = QgsRasterLayer(str(folder / "elevation.tif"), "elevation")
    provider = layer.dataProvider()
    places = ground.places(1000, centers=True)
    ground.check(peer, [provider.sample(QgsPointXY(x, y), 1)[0] for x, y in places], places)
    middle = to_degrees(layer.crs()).transform(QgsPointXY(0.0, 0.0))
    peer.check("place on the earth", layer.crs().isValid(),
               f"{middle.y():.6f}, {middle.x():.6f}; its system: "
               f"{layer.crs().authid() or 'a custom one'}, {layer.crs().description() or 'no name'}")
    stats = provider.bandStatistics(1, QgsRasterBandStats.All)
    peer.check("statistics of the layer", abs(stats.minimumValue - ground.about["lowest"]) < 0.01 and
               abs(stats.maximumValue - ground.about["highest"]) < 0.01,
               f"{stats.minimumValue:.3f} to {stats.maximumValue:.3f} m")
    peer.check("shaded relief", shaded(layer) > 30, f"{shaded(layer)} grey values")
    return layer


def check_classes(peer, folder):
    layer = QgsRasterLayer(str(folder / "classes.tif"), "classes")
    table = layer.dataProvider().colorTable(1)
    names = [item.label for item in table if item.label]
    peer.check("classes", "water bed" in names and len(names) == 9,
               f"drawn as {layer.renderer().type()}, colours in the file: {len(table)}; names in "
               f"the legend: {', '.join(names) or 'none'}")
    water = QgsRasterLayer(str(folder / "water.tif"), "water")
    provider = water.dataProvider()
    peer.check("dry cells of water.tif", provider.sourceHasNoDataValue(1),
               f"no data {provider.sourceNoDataValue(1)}")


def check_assets(peer, elevation):
    """Points of assets.csv lie in the raster's own system."""
    uri = (f"file://{WORLDS / 'world' / 'assets.csv'}?delimiter=,&xField=x_m&yField=y_m"
           "&detectTypes=yes&spatialIndex=no")
    layer = QgsVectorLayer(uri, "assets", "delimitedtext")
    layer.setCrs(elevation.crs())
    rows = assets()
    inside = sum(elevation.extent().contains(feature.geometry().asPoint())
                 for feature in layer.getFeatures()) if layer.isValid() else 0
    peer.check("assets.csv as points", layer.featureCount() == len(rows) and inside == len(rows),
               f"{layer.featureCount()} of {len(rows)}, {inside} of them on the raster")
    zones = QgsVectorLayer(f"Polygon?crs={elevation.crs().toWkt()}", "zones", "memory")
    peer.check("a new layer in its system", zones.isValid(), f"{zones.crs().mapUnits()} (0: metres)")


def main():
    peer = Peer("QGIS", Qgis.QGIS_VERSION.split("-")[0], "`--to geotiff`, `assets.csv`",
                "give `assets.csv` the system of `elevation.tif` when it is added as delimited text")
    application = QgsApplication([], False)
    application.initQgis()
    folder = export("geotiff", "geotiff")
    elevation = check_elevation(peer, folder, Ground(export("heights", "heights")))
    check_classes(peer, folder)
    check_assets(peer, elevation)
    peer.finish()


main()
