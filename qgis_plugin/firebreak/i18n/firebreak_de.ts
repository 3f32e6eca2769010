<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Firebreak</name>
    <message>
        <source>1 Prepare</source>
        <translation>1 Vorbereiten</translation>
    </message>
    <message>
        <source>2 Rank and cut</source>
        <translation>2 Reihen und schneiden</translation>
    </message>
    <message>
        <source>3 Burn</source>
        <translation>3 Brennen</translation>
    </message>
    <message>
        <source>4 Judge</source>
        <translation>4 Beurteilen</translation>
    </message>
    <message>
        <source>Align landscape</source>
        <translation>Landschaft angleichen</translation>
    </message>
    <message>
        <source>Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.</source>
        <translation>Legt Höhe, Vegetation und Dichte auf ein gemeinsames quadratisches Gitter in Metern und übersetzt die Codes in Brennstoffklassen.</translation>
    </message>
    <message>
        <source>The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape (.lcp) as elevation holds all layers.</source>
        <translation>Die Layer dürfen jedes KBS, jede Ausdehnung und jede Zellgröße haben; sie werden auf ein quadratisches Gitter in Metern gelegt. Die Dichte kann ein Raster sein, ein Wort für allen Brennstoff (wie geschlossen er ist), oder fehlen, wenn die Legende sie angibt. Eine FlamMap-Landschaft (.lcp) als Höhe enthält alle Layer.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.</source>
        <translation>Höhe in Metern, in beliebigem KBS und beliebiger Zellgröße; oder eine Landschaftsdatei (.lcp), die alle Layer enthält.</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Vegetation</translation>
    </message>
    <message>
        <source>Codes of the vegetation, explained by the legend.</source>
        <translation>Codes der Vegetation, die die Legende erklärt.</translation>
    </message>
    <message>
        <source>Vegetation density</source>
        <translation>Dichte der Vegetation</translation>
    </message>
    <message>
        <source>Codes of the density of the vegetation; without it the densities come from the legend.</source>
        <translation>Codes der Dichte der Vegetation; ohne sie kommen die Dichten aus der Legende.</translation>
    </message>
    <message>
        <source>Legend of the vegetation codes</source>
        <translation>Legende der Vegetationscodes</translation>
    </message>
    <message>
        <source>What the vegetation codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Was die Vegetationscodes bedeuten: eine mitgelieferte Legende oder eine eigene CSV-Datei.</translation>
    </message>
    <message>
        <source>Fuel models of Anderson 1982</source>
        <translation>Brennstoffmodelle nach Anderson 1982</translation>
    </message>
    <message>
        <source>Canopy cover in percent as density: below 40 sparse, below 70 normal, else dense</source>
        <translation>Kronenschluss in Prozent als Dichte: unter 40 licht, unter 70 normal, sonst dicht</translation>
    </message>
    <message>
        <source>CORINE Land Cover, level 3, three-digit codes</source>
        <translation>CORINE Land Cover, Ebene 3, dreistellige Codes</translation>
    </message>
    <message>
        <source>CORINE Land Cover as the raster of the European Environment Agency holds it: grid codes 1 to 44 in the order of level 3</source>
        <translation>CORINE Land Cover als Raster der Europäischen Umweltagentur: Gittercodes 1 bis 44 in der Reihenfolge der Ebene 3</translation>
    </message>
    <message>
        <source>Vegetation densities of Russo, Russo, Siettos 2016</source>
        <translation>Vegetationsdichten nach Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Fuel map of Europe in 12 classes, as the PROPAGATOR fire model uses it</source>
        <translation>Brennstoffkarte Europas in 12 Klassen, wie das Feuermodell PROPAGATOR sie benutzt</translation>
    </message>
    <message>
        <source>Fuel types of the Canadian Forest Fire Behavior Prediction System</source>
        <translation>Brennstofftypen des Canadian Forest Fire Behavior Prediction System</translation>
    </message>
    <message>
        <source>Fuel models of Portugal</source>
        <translation>Brennstoffmodelle Portugals</translation>
    </message>
    <message>
        <source>Fuel models of the Chilean Kitral system, codes as in Cell2Fire</source>
        <translation>Brennstoffmodelle des chilenischen Systems Kitral, Codes wie in Cell2Fire</translation>
    </message>
    <message>
        <source>Vegetation types of Russo, Russo, Siettos 2016</source>
        <translation>Vegetationstypen nach Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Vegetation of the PROPAGATOR fire model in 7 classes</source>
        <translation>Vegetation des Feuermodells PROPAGATOR in 7 Klassen</translation>
    </message>
    <message>
        <source>Fire behaviour fuel models of Scott and Burgan 2005</source>
        <translation>Brennstoffmodelle nach Scott und Burgan 2005</translation>
    </message>
    <message>
        <source>Tree cover density in percent</source>
        <translation>Baumbedeckung in Prozent</translation>
    </message>
    <message>
        <source>ESA WorldCover 10 m, codes of releases 2020 v100 and 2021 v200</source>
        <translation>ESA WorldCover 10 m, Codes der Ausgaben 2020 v100 und 2021 v200</translation>
    </message>
    <message>
        <source>as one class for all fuel</source>
        <translation>als eine Klasse für allen Brennstoff</translation>
    </message>
    <message>
        <source>Sparse everywhere</source>
        <translation>Überall licht</translation>
    </message>
    <message>
        <source>Normal everywhere</source>
        <translation>Überall normal</translation>
    </message>
    <message>
        <source>Dense everywhere</source>
        <translation>Überall dicht</translation>
    </message>
    <message>
        <source>As closed as the fuel around each cell is</source>
        <translation>So geschlossen wie der Brennstoff um jede Zelle</translation>
    </message>
    <message>
        <source>as a CSV file</source>
        <translation>als CSV-Datei</translation>
    </message>
    <message>
        <source>Creation options, such as COMPRESS=ZSTD</source>
        <translation>Erzeugungsoptionen, z. B. COMPRESS=ZSTD</translation>
    </message>
    <message>
        <source>Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.</source>
        <translation>Erzeugungsoption des COG-Treibers von GDAL, z. B. COMPRESS=ZSTD.</translation>
    </message>
    <message>
        <source>Legend of the density codes</source>
        <translation>Legende der Dichtecodes</translation>
    </message>
    <message>
        <source>What the density codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Was die Dichtecodes bedeuten: eine mitgelieferte Legende oder eine eigene CSV-Datei.</translation>
    </message>
    <message>
        <source>CRS of the grid</source>
        <translation>KBS des Gitters</translation>
    </message>
    <message>
        <source>CRS of the grid, projected in metres [default: the "Elevation"'s if it is in metres, else the UTM zone].</source>
        <translation>KBS des Gitters, projiziert in Metern [sonst das von "Höhe", wenn es in Metern ist, sonst die UTM-Zone].</translation>
    </message>
    <message>
        <source>Cell size [m]</source>
        <translation>Zellgröße [m]</translation>
    </message>
    <message>
        <source>Cell size [default: the "Elevation"'s].</source>
        <translation>Zellgröße [sonst die von "Höhe"].</translation>
    </message>
    <message>
        <source>Extent (needs the CRS of the grid)</source>
        <translation>Ausdehnung (braucht das KBS des Gitters)</translation>
    </message>
    <message>
        <source>Extent in the CRS of the grid [default: what all layers cover].</source>
        <translation>Ausdehnung im KBS des Gitters [sonst, was alle Layer abdecken].</translation>
    </message>
    <message>
        <source>Take the grid of this raster</source>
        <translation>Gitter dieses Rasters übernehmen</translation>
    </message>
    <message>
        <source>Take the grid of this raster.</source>
        <translation>Übernimmt das Gitter dieses Rasters.</translation>
    </message>
    <message>
        <source>True CRS of the layers, such as dem=EPSG:32635</source>
        <translation>Wahres KBS der Layer, z. B. dem=EPSG:32635</translation>
    </message>
    <message>
        <source>The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.</source>
        <translation>Das wahre KBS von dem, vegetation oder density, oder von allen, wo eine Datei keines oder ein falsches nennt.</translation>
    </message>
    <message>
        <source>No-data values, such as dem=-9999; vegetation=255</source>
        <translation>Leerwerte, z. B. dem=-9999; vegetation=255</translation>
    </message>
    <message>
        <source>Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says that all are data; several are separated by ;.</source>
        <translation>Werte, die in dem, vegetation oder density keine Daten bedeuten, z. B. dem=-9999,32767; dem=none heißt, dass alle Daten sind; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Bands, such as dem=1; vegetation=2</source>
        <translation>Kanäle, z. B. dem=1; vegetation=2</translation>
    </message>
    <message>
        <source>Band to read of dem, vegetation or density.</source>
        <translation>Kanal, der von dem, vegetation oder density gelesen wird.</translation>
    </message>
    <message>
        <source>Codes that the legend does not list</source>
        <translation>Codes, die in der Legende fehlen</translation>
    </message>
    <message>
        <source>What to do with codes that the legend does not list.</source>
        <translation>Was mit Codes geschieht, die in der Legende fehlen.</translation>
    </message>
    <message>
        <source>Refuse them</source>
        <translation>Zurückweisen</translation>
    </message>
    <message>
        <source>Take them as land without fuel</source>
        <translation>Als Land ohne Brennstoff nehmen</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of</source>
        <translation>Zurückweisen, wovor sonst nur gewarnt wird</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of.</source>
        <translation>Weist zurück, wovor sonst nur gewarnt würde.</translation>
    </message>
    <message>
        <source>Allow network addresses and archives</source>
        <translation>Netzwerkadressen und Archive erlauben</translation>
    </message>
    <message>
        <source>Allow "Elevation", "Vegetation" and "Vegetation density" to be network addresses or in archives.</source>
        <translation>Erlaubt, dass "Höhe", "Vegetation" und "Dichte der Vegetation" Netzwerkadressen sind oder in Archiven liegen.</translation>
    </message>
    <message>
        <source>Most memory to use, such as 4GB</source>
        <translation>Höchster Speicherbedarf, z. B. 4GB</translation>
    </message>
    <message>
        <source>Refuse work that needs more, e.g. 4GB [default: most of what there is].</source>
        <translation>Weist Arbeit zurück, die mehr braucht, z. B. 4GB [sonst das meiste von dem, was da ist].</translation>
    </message>
    <message>
        <source>Calibration, or the account (run.json) of an earlier run</source>
        <translation>Kalibrierung, oder Protokoll (run.json) eines früheren Laufs</translation>
    </message>
    <message>
        <source>Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.</source>
        <translation>Nimmt Parameter aus einer TOML-Datei oder aus der run.json eines früheren Laufs; was hier angegeben wird, geht vor.</translation>
    </message>
    <message>
        <source>Elevation on the common grid</source>
        <translation>Höhe auf dem gemeinsamen Gitter</translation>
    </message>
    <message>
        <source>Vegetation classes on the common grid</source>
        <translation>Vegetationsklassen auf dem gemeinsamen Gitter</translation>
    </message>
    <message>
        <source>Density classes on the common grid</source>
        <translation>Dichteklassen auf dem gemeinsamen Gitter</translation>
    </message>
    <message>
        <source>Effect of the vegetation, where the legend gives numbers in place of classes</source>
        <translation>Wirkung der Vegetation, wo die Legende Zahlen statt Klassen angibt</translation>
    </message>
    <message>
        <source>Effect of the density, where the legend gives numbers in place of classes</source>
        <translation>Wirkung der Dichte, wo die Legende Zahlen statt Klassen angibt</translation>
    </message>
    <message>
        <source>Rate of spread on flat calm dry ground, where the legend gives it</source>
        <translation>Ausbreitungsgeschwindigkeit auf ebenem, trockenem Boden ohne Wind, wo die Legende sie angibt</translation>
    </message>
    <message>
        <source>Load of dead fuel, where the legend gives it</source>
        <translation>Menge des toten Brennstoffs, wo die Legende sie angibt</translation>
    </message>
    <message>
        <source>Load of live fuel, where the legend gives it</source>
        <translation>Menge des lebenden Brennstoffs, wo die Legende sie angibt</translation>
    </message>
    <message>
        <source>Heat content of the fuel, where the legend gives it</source>
        <translation>Heizwert des Brennstoffs, wo die Legende ihn angibt</translation>
    </message>
    <message>
        <source>Moisture of the live fuel, where the legend gives it</source>
        <translation>Feuchte des lebenden Brennstoffs, wo die Legende sie angibt</translation>
    </message>
    <message>
        <source>Account of the run</source>
        <translation>Protokoll des Laufs</translation>
    </message>
    <message>
        <source>Folder for all files</source>
        <translation>Ordner für alle Dateien</translation>
    </message>
    <message>
        <source>Spread network</source>
        <translation>Ausbreitungsnetz</translation>
    </message>
    <message>
        <source>Find how likely fire spreads from each cell to its neighbours.</source>
        <translation>Ermittelt, wie wahrscheinlich Feuer von jeder Zelle auf ihre Nachbarn übergreift.</translation>
    </message>
    <message>
        <source>Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). Wind and slope then act on the times; so make a network without times for fires without a duration.</source>
        <translation>Die Kanäle 1 bis 8 enthalten die Wahrscheinlichkeit, dass Feuer nach N, NO, O, SO, S, SW, W und NW übergreift. Werden auch Zeiten angegeben, enthalten die Kanäle 9 bis 16 die Sekunden, die das dauert, und Kanal 17 die Wärme, die die Zelle freisetzt (kJ/m2). Wind und Hang wirken dann auf die Zeiten; für Feuer ohne Dauer ist also ein Netz ohne Zeiten zu nehmen.</translation>
    </message>
    <message>
        <source>Cells with fuel</source>
        <translation>Zellen mit Brennstoff</translation>
    </message>
    <message>
        <source>Spread model</source>
        <translation>Ausbreitungsmodell</translation>
    </message>
    <message>
        <source>How fire gets from a cell to its neighbours; all are described below.</source>
        <translation>Wie Feuer von einer Zelle zu ihren Nachbarn kommt; alle Modelle sind unten beschrieben.</translation>
    </message>
    <message>
        <source>Alexandridis: cellular automaton of vegetation type, density, slope and wind</source>
        <translation>Alexandridis: zellulärer Automat aus Vegetationstyp, Dichte, Hang und Wind</translation>
    </message>
    <message>
        <source>Artificial forest: the probability of catching fire is the fuel of the target cell</source>
        <translation>Künstlicher Wald: die Wahrscheinlichkeit, Feuer zu fangen, ist der Brennstoff der Zielzelle</translation>
    </message>
    <message>
        <source>Raster: your own probabilities, and perhaps travel times, from another fire model</source>
        <translation>Raster: eigene Wahrscheinlichkeiten, und wenn vorhanden Laufzeiten, aus einem anderen Feuermodell</translation>
    </message>
    <message>
        <source>Wind speed [m/s]</source>
        <translation>Windgeschwindigkeit [m/s]</translation>
    </message>
    <message>
        <source>Wind speed at mid-flame height in m/s, or a raster of it on any grid.</source>
        <translation>Windgeschwindigkeit in halber Flammenhöhe in m/s, oder ein Raster davon auf beliebigem Gitter.</translation>
    </message>
    <message>
        <source>Wind from [degrees clockwise from north]</source>
        <translation>Wind aus [Grad im Uhrzeigersinn von Nord]</translation>
    </message>
    <message>
        <source>Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.</source>
        <translation>Richtung, aus der der Wind kommt, im Uhrzeigersinn von Nord: 270 ist Westwind; eine Zahl oder ein Raster.</translation>
    </message>
    <message>
        <source>Tell times too (for fires with a duration)</source>
        <translation>Auch Zeiten angeben (für Feuer mit einer Dauer)</translation>
    </message>
    <message>
        <source>Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.</source>
        <translation>Gibt auch an, wie lange Feuer von Zelle zu Zelle braucht (Kanäle 9 bis 16, Sekunden), und die Wärme jeder Zelle.</translation>
    </message>
    <message>
        <source>as a raster</source>
        <translation>als Raster</translation>
    </message>
    <message>
        <source>Wind towards east and north, in place of speed and direction [m/s]</source>
        <translation>Wind nach Ost und Nord, statt Geschwindigkeit und Richtung [m/s]</translation>
    </message>
    <message>
        <source>Components of the wind towards east and north, in place of the two above: rasters on any grid.</source>
        <translation>Komponenten des Windes nach Ost und Nord, an Stelle der beiden oben: Raster auf beliebigem Gitter.</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel (8 % is 0.08)</source>
        <translation>Feuchte des feinen toten Brennstoffs (8 % sind 0.08)</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.</source>
        <translation>Feuchte des feinen toten Brennstoffs als Anteil seines Trockengewichts (8 % sind 0.08 oder 8%), oder ein Raster davon.</translation>
    </message>
    <message>
        <source>Neighbours that a cell can light</source>
        <translation>Nachbarn, die eine Zelle entzünden kann</translation>
    </message>
    <message>
        <source>Cells to which fire can spread from a cell.</source>
        <translation>Zellen, auf die Feuer von einer Zelle übergreifen kann.</translation>
    </message>
    <message>
        <source>All eight</source>
        <translation>Alle acht</translation>
    </message>
    <message>
        <source>The four that share a side</source>
        <translation>Die vier mit gemeinsamer Seite</translation>
    </message>
    <message>
        <source>Parameters of the spread model, such as p0=0.5</source>
        <translation>Parameter des Ausbreitungsmodells, z. B. p0=0.5</translation>
    </message>
    <message>
        <source>Parameter of the spread model, e.g. p0=0.5; several are separated by ;.</source>
        <translation>Parameter des Ausbreitungsmodells, z. B. p0=0.5; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>File with the probabilities for other tools (.mtx, .npz)</source>
        <translation>Datei mit den Wahrscheinlichkeiten für andere Programme (.mtx, .npz)</translation>
    </message>
    <message>
        <source>Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or .graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.</source>
        <translation>Schreibt die Wahrscheinlichkeiten auch für andere Programme: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) oder .graphml (bis 20,000 Zellen mit Brennstoff). Zellen sind zeilenweise von links oben gezählt.</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; with 8 by 0.002 and 3.4 %. Every command reads such files.</source>
        <translation>Bits einer Zahl in der Datei. Mit 16 sind Wahrscheinlichkeiten um höchstens 8e-6 falsch, Zeiten und Wärme um 0.013 %; mit 8 um 0.002 und 3.4 %. Jeder Befehl liest solche Dateien.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>Where a line can be held</source>
        <translation>Wo eine Linie zu halten ist</translation>
    </message>
    <message>
        <source>Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by it.</source>
        <translation>Bewertet von 0 bis 1, wie gut eine Linie in jeder Zelle zu halten ist: was die beste Linie in Reichweite wert ist (Kämme, Talböden, Straßen, Flüsse, Ränder des Brennstoffs), dazu der Hang für Maschinen und der Zugang. Pläne richten sich danach.</translation>
    </message>
    <message>
        <source>The weights have no source for your region: they are yours to set.</source>
        <translation>Für die Gewichte gibt es in Ihrer Region keine Quelle: Sie setzen sie selbst.</translation>
    </message>
    <message>
        <source>Mean suitability where there is fuel</source>
        <translation>Mittlere Eignung, wo Brennstoff ist</translation>
    </message>
    <message>
        <source>Roads and tracks</source>
        <translation>Straßen und Wege</translation>
    </message>
    <message>
        <source>Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which crews drive; those that stop fire are barriers too.</source>
        <translation>Straßen und Wege (Linien oder ein Raster), neben denen Schneisen leichter zu bauen und zu halten sind, und auf denen die Mannschaften fahren; die Feuer aufhalten, sind auch Barrieren.</translation>
    </message>
    <message>
        <source>Rivers and lakes</source>
        <translation>Flüsse und Seen</translation>
    </message>
    <message>
        <source>Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are barriers too.</source>
        <translation>Flüsse und Seen (Linien, Flächen, ein Raster), neben denen Schneisen leichter zu halten sind; die Feuer aufhalten, sind auch Barrieren.</translation>
    </message>
    <message>
        <source>What lines of the ground are worth, such as ridge=0.8; reach=60</source>
        <translation>Was Linien im Gelände wert sind, z. B. ridge=0.8; reach=60</translation>
    </message>
    <message>
        <source>What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; several are separated by ;.</source>
        <translation>Was eine Linie wert ist, oder eine Reichweite, z. B. ridge=0.8, valley=0 oder reach=60; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines</source>
        <translation>Brandabschnitte zwischen Kontrolllinien</translation>
    </message>
    <message>
        <source>Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: potential operational delineations (PODs), on which crews agree before a fire.</source>
        <translation>Die Landschaft in etwa gleich große Brandabschnitte teilen, begrenzt von den Linien, die am leichtesten zu halten sind: mögliche Einsatzabschnitte (PODs), auf die sich Einsatzkräfte vor einem Feuer einigen.</translation>
    </message>
    <message>
        <source>Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. The second layer of the file holds the borders.</source>
        <translation>Jeder Abschnitt hat seinen Brennstoff, seine Zündungen und Werte, das, was in simulierten Feuern brennt, und die Güte seiner Grenze. Der zweite Layer der Datei enthält die Grenzen.</translation>
    </message>
    <message>
        <source>Compartments</source>
        <translation>Brandabschnitte</translation>
    </message>
    <message>
        <source>Borders in kilometres</source>
        <translation>Grenzen in Kilometern</translation>
    </message>
    <message>
        <source>Mean suitability of the borders</source>
        <translation>Mittlere Eignung der Grenzen</translation>
    </message>
    <message>
        <source>Size of the compartments, such as 500ha</source>
        <translation>Größe der Brandabschnitte, z. B. 500ha</translation>
    </message>
    <message>
        <source>Size of the compartments, hectares of fuel; none is larger than one and a half times this.</source>
        <translation>Größe der Brandabschnitte in Hektar Brennstoff; keiner ist größer als das Anderthalbfache.</translation>
    </message>
    <message>
        <source>Values at risk</source>
        <translation>Gefährdete Werte</translation>
    </message>
    <message>
        <source>Values at risk: a raster, or polygons or points with "Field with the value" [default: 1 on fuel].</source>
        <translation>Gefährdete Werte: ein Raster, oder Polygone oder Punkte mit "Feld mit dem Wert" [sonst 1 auf Brennstoff].</translation>
    </message>
    <message>
        <source>How long fires burn, such as 8h</source>
        <translation>Wie lange Feuer brennen, z. B. 8h</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: lognormal:8h,0.7, an assumption].</source>
        <translation>Wie lange Feuer brennen: 8h, eine Liste, die die Läufe der Reihe nach nehmen (4h,8h), lognormal:8h,0.7 (Median und Sigma), uniform:2h,12h, oder weather [sonst lognormal:8h,0.7, eine Annahme].</translation>
    </message>
    <message>
        <source>Ignition points</source>
        <translation>Zündpunkte</translation>
    </message>
    <message>
        <source>Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of ignition probability [default: one random cell with fuel a run].</source>
        <translation>Punkte, Polygone (Umrisse, die schon brennen; jede Vektordatei, oder CSV mit x und y) oder ein Raster der Zündwahrscheinlichkeit [sonst je Lauf eine zufällige Zelle mit Brennstoff].</translation>
    </message>
    <message>
        <source>Number of fires</source>
        <translation>Anzahl der Feuer</translation>
    </message>
    <message>
        <source>Simulated fires.</source>
        <translation>Simulierte Feuer.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert des Zufalls</translation>
    </message>
    <message>
        <source>Seed of all draws.</source>
        <translation>Startwert aller Zufallszahlen.</translation>
    </message>
    <message>
        <source>How much more the worst ground counts than the best</source>
        <translation>Um wie viel mehr der schlechteste Boden zählt als der beste</translation>
    </message>
    <message>
        <source>Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.</source>
        <translation>Wievielmal so viel der schlechteste Boden zählt wie der beste, 1 bis 100; 1 verlangt die kürzesten Grenzen.</translation>
    </message>
    <message>
        <source>Field with the value</source>
        <translation>Feld mit dem Wert</translation>
    </message>
    <message>
        <source>Column of the value polygons or points [default: 1 for each].</source>
        <translation>Spalte der Wertpolygone oder -punkte [sonst 1 für jedes].</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Die Werte sind</translation>
    </message>
    <message>
        <source>What the numbers of "Values at risk" are: so much in each cell of the raster, polygon or point (people), the sum of which is kept; or so much a hectare.</source>
        <translation>Was die Zahlen von "Gefährdete Werte" sind: soviel in jeder Zelle des Rasters, jedem Polygon oder Punkt (Menschen), wovon die Summe erhalten bleibt; oder soviel je Hektar.</translation>
    </message>
    <message>
        <source>So much in each cell, polygon or point</source>
        <translation>Soviel je Zelle, Polygon oder Punkt</translation>
    </message>
    <message>
        <source>So much a hectare</source>
        <translation>Soviel je Hektar</translation>
    </message>
    <message>
        <source>Several values at risk, such as people=villages.gpkg,weight=2</source>
        <translation>Mehrere gefährdete Werte, z. B. people=villages.gpkg,weight=2</translation>
    </message>
    <message>
        <source>Several values at risk, each as a name and a file, with its field, a weight (what a unit counts in the sum that is planned for) and as=density after it as needed; several are separated by ;, each is told by name.</source>
        <translation>Mehrere gefährdete Werte, jeder als Name und Datei, dahinter nach Bedarf sein Feld, ein Gewicht (was eine Einheit in der Summe zählt, für die geplant wird) und as=density; mehrere durch ; getrennt, jeder wird mit Namen angegeben.</translation>
    </message>
    <message>
        <source>Conditions on features, such as barriers=highway = 'primary'</source>
        <translation>Bedingungen an Objekte, z. B. barriers=highway = 'primary'</translation>
    </message>
    <message>
        <source>Take only features that fit a condition, with the name of the layer before it, such as barriers=highway = 'primary'; several are separated by ;.</source>
        <translation>Nimmt nur Objekte, die eine Bedingung erfüllen, mit dem Namen des Layers davor, z. B. barriers=highway = 'primary'; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Use of the ignition points</source>
        <translation>Verwendung der Zündpunkte</translation>
    </message>
    <message>
        <source>With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or start where such fires of the past are dense.</source>
        <translation>Bei Punkten oder Polygonen: die Läufe nehmen sie der Reihe nach (der Startwert lost die Folge), beginnen an allen, oder beginnen, wo solche Feuer der Vergangenheit dicht liegen.</translation>
    </message>
    <message>
        <source>One for each fire, in turn</source>
        <translation>Einer je Feuer, der Reihe nach</translation>
    </message>
    <message>
        <source>All at once in every fire</source>
        <translation>Alle zugleich in jedem Feuer</translation>
    </message>
    <message>
        <source>More fires where they are dense</source>
        <translation>Mehr Feuer, wo sie dicht liegen</translation>
    </message>
    <message>
        <source>Ignition points without fuel</source>
        <translation>Zündpunkte ohne Brennstoff</translation>
    </message>
    <message>
        <source>What to do with points and polygons off the landscape or without fuel.</source>
        <translation>Was mit Punkten und Polygonen außerhalb der Landschaft oder ohne Brennstoff geschieht.</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Column with the hour of each ignition</source>
        <translation>Spalte mit der Stunde jeder Zündung</translation>
    </message>
    <message>
        <source>Column of the ignitions that tells when each is lit, in hours after the start of the run.</source>
        <translation>Spalte der Zündungen, die sagt, wann jede entsteht, in Stunden nach Beginn des Laufs.</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Flugfeuer</translation>
    </message>
    <message>
        <source>Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.</source>
        <translation>Glut, die dem Feuer vorausfliegt: on, oder Zahlen wie rate=12,longest=1000 an Stelle der angenommenen.</translation>
    </message>
    <message>
        <source>When crews contain a fire, such as 6h</source>
        <translation>Wann Einsatzkräfte ein Feuer eindämmen, z. B. 6h</translation>
    </message>
    <message>
        <source>When crews contain each fire: a time or a distribution as for "How long fires burn", or a direct attack at such a time, which fails if the fire is too large or too fierce by then: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].</source>
        <translation>Wann Einsatzkräfte jedes Feuer eindämmen: eine Zeit oder eine Verteilung wie für "Wie lange Feuer brennen", oder ein direkter Angriff zu solcher Zeit, der misslingt, wenn das Feuer dann zu groß oder zu heftig ist: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha darüber) [sonst nie].</translation>
    </message>
    <message>
        <source>How often a break holds, such as 0.47</source>
        <translation>Wie oft eine Schneise hält, z. B. 0.47</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: 0.47, an assumption].</source>
        <translation>Wie oft ein Stück Schneise in einem Lauf hält: ein Anteil (0.47 im Gelände), flame (nach Breite und Intensität des Feuers, Wilson 1988) oder flame:flames (1.5 Flammenlängen); Stücke haben 400 m, oder wie in 0.47:800 [sonst 0.47, eine Annahme].</translation>
    </message>
    <message>
        <source>How often a barrier holds, such as 0.9</source>
        <translation>Wie oft eine Barriere hält, z. B. 0.9</translation>
    </message>
    <message>
        <source>Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.</source>
        <translation>Anteil der Läufe, in denen ein Stück der Barrieren hält; getrennt von den Schneisen gezogen.</translation>
    </message>
    <message>
        <source>Stations of crews whom breaks wait for</source>
        <translation>Standorte der Einsatzkräfte, auf die Schneisen warten</translation>
    </message>
    <message>
        <source>Points or areas that crews set out from: a stretch of break holds only against fire that comes after them [default: crews are everywhere].</source>
        <translation>Punkte oder Flächen, von denen Einsatzkräfte aufbrechen: ein Stück Schneise hält nur gegen Feuer, das nach ihnen kommt [sonst sind Einsatzkräfte überall].</translation>
    </message>
    <message>
        <source>Travel of crews, such as road=40,off=3,delay=10</source>
        <translation>Fahrt der Einsatzkräfte, z. B. road=40,off=3,delay=10</translation>
    </message>
    <message>
        <source>How they travel: speed on roads and off them in km/h, and minutes from the start of the fire until they leave [default: road=40,off=3,delay=10, assumptions].</source>
        <translation>Wie sie fahren: Geschwindigkeit auf Straßen und abseits in km/h, und Minuten vom Beginn des Feuers bis zum Aufbruch [sonst road=40,off=3,delay=10, Annahmen].</translation>
    </message>
    <message>
        <source>Fires without an end by time</source>
        <translation>Feuer ohne zeitliches Ende</translation>
    </message>
    <message>
        <source>Fires end by themselves and breaks hold in every fire unless "How often a break holds" says otherwise, as in the paper.</source>
        <translation>Feuer enden von selbst, und Schneisen halten in jedem Feuer, wenn "Wie oft eine Schneise hält" nichts anderes sagt, wie in der Veröffentlichung.</translation>
    </message>
    <message>
        <source>Table of weather</source>
        <translation>Wettertabelle</translation>
    </message>
    <message>
        <source>Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2.</source>
        <translation>Menge von Wetterlagen, von denen jeder Lauf eine zieht: eine CSV-Datei mit wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; oder eine Windrose wie rose:NW=5x0.4,N=8x0.2.</translation>
    </message>
    <message>
        <source>as a wind rose: rose:NW=5x0.4,N=8x0.2</source>
        <translation>als Windrose: rose:NW=5x0.4,N=8x0.2</translation>
    </message>
    <message>
        <source>Time of each line of the table of weather, such as 1h</source>
        <translation>Dauer jeder Zeile der Wettertabelle, z. B. 1h</translation>
    </message>
    <message>
        <source>The lines of the weather follow each other, and each lasts so long, e.g. 1h.</source>
        <translation>Die Zeilen des Wetters folgen aufeinander, und jede dauert so lange, z. B. 1h.</translation>
    </message>
    <message>
        <source>Columns of the table of weather, such as wind_speed=FF</source>
        <translation>Spalten der Wettertabelle, z. B. wind_speed=FF</translation>
    </message>
    <message>
        <source>Name of a column of the weather, e.g. wind_speed=FF; several are separated by ;.</source>
        <translation>Name einer Spalte des Wetters, z. B. wind_speed=FF; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Units of the table of weather, such as wind_speed=kn</source>
        <translation>Einheiten der Wettertabelle, z. B. wind_speed=kn</translation>
    </message>
    <message>
        <source>Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; several are separated by ;.</source>
        <translation>Einheit einer Spalte des Wetters, die sie nicht nennt, z. B. wind_speed=kn; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Columns of the table of weather to leave out</source>
        <translation>Spalten der Wettertabelle, die wegbleiben</translation>
    </message>
    <message>
        <source>Columns of the weather to leave out, separated by commas.</source>
        <translation>Spalten des Wetters, die wegbleiben, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, and their borders</source>
        <translation>Brandabschnitte zwischen Kontrolllinien, und ihre Grenzen</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, without outlines</source>
        <translation>Brandabschnitte zwischen Kontrolllinien, ohne Umrisse</translation>
    </message>
    <message>
        <source>Borders of the compartments, without lines</source>
        <translation>Grenzen der Brandabschnitte, ohne Linien</translation>
    </message>
    <message>
        <source>Plan fire breaks</source>
        <translation>Brandschneisen planen</translation>
    </message>
    <message>
        <source>Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and with the breaks.</source>
        <translation>Plant Brandschneisen aus Layern: wo geschnitten wird, was zuerst zu bauen ist, und wie oft jede Zelle ohne und mit Schneisen brennt.</translation>
    </message>
    <message>
        <source>Cells cut</source>
        <translation>Geschnittene Zellen</translation>
    </message>
    <message>
        <source>Area cut in hectares</source>
        <translation>Geschnittene Fläche in Hektar</translation>
    </message>
    <message>
        <source>Mean burnt share without breaks</source>
        <translation>Mittlerer verbrannter Anteil ohne Schneisen</translation>
    </message>
    <message>
        <source>Mean burnt share with the breaks</source>
        <translation>Mittlerer verbrannter Anteil mit den Schneisen</translation>
    </message>
    <message>
        <source>Area where nothing may be cut</source>
        <translation>Gebiet, in dem nichts geschnitten werden darf</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.</source>
        <translation>Gebiet (Raster oder Polygone; Linien nehmen die Zellen, die sie berühren), in dem nichts geschnitten werden darf.</translation>
    </message>
    <message>
        <source>Existing barriers</source>
        <translation>Vorhandene Barrieren</translation>
    </message>
    <message>
        <source>Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and cost nothing.</source>
        <translation>Vorhandene Schneisen, Straßen, Flüsse (Raster, Linien oder Polygone): alle Zellen, die sie schneiden, haben keinen Brennstoff und kosten nichts.</translation>
    </message>
    <message>
        <source>Budget, such as 10%, 5ha or 20000eur</source>
        <translation>Budget, z. B. 10%, 5ha oder 20000eur</translation>
    </message>
    <message>
        <source>How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or money such as 20000eur, in the currency of the costs.</source>
        <translation>Wie viel geschnitten wird: ein Anteil der Zellen mit Brennstoff wie 10% oder 0.1, eine Fläche wie 5ha, oder Geld wie 20000eur, in der Währung der Kosten.</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Rangfolge</translation>
    </message>
    <message>
        <source>By which cells are ranked; higher is cut earlier. All are described below.</source>
        <translation>Wonach Zellen gereiht werden; höher wird früher geschnitten. Alle sind unten beschrieben.</translation>
    </message>
    <message>
        <source>Betweenness centrality: cells that lie on many fastest routes of fire</source>
        <translation>Betweenness-Zentralität: Zellen, die auf vielen schnellsten Wegen des Feuers liegen</translation>
    </message>
    <message>
        <source>Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves</source>
        <translation>Bonacich-Zentralität: Zellen, durch die Feuer Zellen erreicht, die selbst leicht erreicht werden</translation>
    </message>
    <message>
        <source>Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere</source>
        <translation>Closeness-Zentralität: Zellen, die Feuer von überall bald erreicht, oder von denen es bald überall ist</translation>
    </message>
    <message>
        <source>Compartments: a square grid of bands that encloses equal ones</source>
        <translation>Brandabschnitte: ein quadratisches Netz von Streifen, das gleiche Abschnitte umschließt</translation>
    </message>
    <message>
        <source>Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone</source>
        <translation>Stromfluss-Betweenness: Zellen, durch die sich Feuer auf irgendeinem Weg ausbreitet, nicht nur auf dem schnellsten</translation>
    </message>
    <message>
        <source>Degree: cells that are lit by, or light, their neighbours most</source>
        <translation>Grad: Zellen, die am meisten von ihren Nachbarn entzündet werden oder sie entzünden</translation>
    </message>
    <message>
        <source>Defensible fuel profile zones (DFPZ): broad bands along roads and ridges</source>
        <translation>Verteidigbare Brennstoffzonen (DFPZ): breite Streifen entlang von Wegen und Kämmen</translation>
    </message>
    <message>
        <source>Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first</source>
        <translation>Zerlegung: Wände zwischen Brandabschnitten aus geschachtelten minimalen Schnitten, die lohnendsten zuerst</translation>
    </message>
    <message>
        <source>Dominator: exact gain of cutting one cell, found anew after every few cuts</source>
        <translation>Dominator: genauer Gewinn aus dem Schneiden einer Zelle, nach wenigen Schnitten jeweils neu bestimmt</translation>
    </message>
    <message>
        <source>DomiRank: cells that dominate their neighbourhood when neighbours compete</source>
        <translation>DomiRank: Zellen, die ihre Umgebung beherrschen, wenn Nachbarn im Wettbewerb stehen</translation>
    </message>
    <message>
        <source>Downstream protection value: cells from which most value was lit, found anew after every few cuts</source>
        <translation>Schutzwert stromab: Zellen, von denen aus der meiste Wert entzündet wurde, nach wenigen Schnitten jeweils neu bestimmt</translation>
    </message>
    <message>
        <source>Eigenvector centrality: cells next to the cells that matter most, all in one place of the map</source>
        <translation>Eigenvektor-Zentralität: Zellen neben den wichtigsten Zellen, alle an einer Stelle der Karte</translation>
    </message>
    <message>
        <source>Flammability: most flammable cells first, the conventional policy, which looks at each cell alone</source>
        <translation>Brennbarkeit: die brennbarsten Zellen zuerst, das übliche Vorgehen, das jede Zelle für sich ansieht</translation>
    </message>
    <message>
        <source>Group betweenness: built cell by cell, each covers fastest routes that the group leaves open</source>
        <translation>Gruppen-Betweenness: Zelle für Zelle gebildet, jede deckt schnellste Wege, die die Gruppe noch offen lässt</translation>
    </message>
    <message>
        <source>Influence: cells by way of which fires with a clock take most, found anew after every few cuts on the same draws</source>
        <translation>Einfluss: Zellen, über die Feuer mit Zeitablauf am meisten erfassen; nach je einigen Schnitten mit denselben Ziehungen neu ermittelt</translation>
    </message>
    <message>
        <source>Information centrality: cells that many parallel ways of spread join closely to all others</source>
        <translation>Informations-Zentralität: Zellen, die viele parallele Ausbreitungswege eng mit allen anderen verbinden</translation>
    </message>
    <message>
        <source>PageRank: cells that a fire wandering at random from cell to cell is often in</source>
        <translation>PageRank: Zellen, in denen ein zufällig wanderndes Feuer oft ist</translation>
    </message>
    <message>
        <source>Percolation centrality: cells on many fastest routes from where fires start</source>
        <translation>Perkolations-Zentralität: Zellen auf vielen schnellsten Wegen von dort, wo Feuer entstehen</translation>
    </message>
    <message>
        <source>Random: cells in random order, the baseline that every plan must beat</source>
        <translation>Zufall: Zellen in zufälliger Folge, das Maß, das jeder Plan übertreffen muss</translation>
    </message>
    <message>
        <source>Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them</source>
        <translation>Strategisch gesetzte Behandlungsflächen (SPLAT): versetzte Flächen, die ein Feuer bremsen, ohne gerade Durchfahrt</translation>
    </message>
    <message>
        <source>Stripes: parallel bands across a direction, the plainest pattern of practice</source>
        <translation>Streifen: parallele Bänder quer zu einer Richtung, das schlichteste Muster der Praxis</translation>
    </message>
    <message>
        <source>Unit of a budget that is a plain number</source>
        <translation>Einheit eines Budgets, das eine bloße Zahl ist</translation>
    </message>
    <message>
        <source>What a plain number for "Budget" counts: a share of the fuel, hectares, or money [default: share].</source>
        <translation>Was eine bloße Zahl für "Budget" zählt: einen Anteil des Brennstoffs, Hektar, oder Geld [sonst Anteil].</translation>
    </message>
    <message>
        <source>Share of the fuel (0 to 1)</source>
        <translation>Anteil des Brennstoffs (0 bis 1)</translation>
    </message>
    <message>
        <source>Hectares</source>
        <translation>Hektar</translation>
    </message>
    <message>
        <source>Money</source>
        <translation>Geld</translation>
    </message>
    <message>
        <source>Parameters of the ranking, such as beta=0.5; width=60</source>
        <translation>Parameter der Rangfolge, z. B. beta=0.5; width=60</translation>
    </message>
    <message>
        <source>Parameter of the ranking, e.g. beta=0.5; several are separated by ;.</source>
        <translation>Parameter der Rangfolge, z. B. beta=0.5; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Share of the spread that a break lets through</source>
        <translation>Anteil der Ausbreitung, den eine Schneise durchlässt</translation>
    </message>
    <message>
        <source>Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.</source>
        <translation>Anteil seiner Ausbreitungswahrscheinlichkeit, den eine behandelte Zelle behält; 0 ist eine vollkommene Schneise, wirkliche sind durchlässig.</translation>
    </message>
    <message>
        <source>Least width of the breaks [m]</source>
        <translation>Mindestbreite der Schneisen [m]</translation>
    </message>
    <message>
        <source>Least width of the breaks, rounded up to whole cells [default: one cell, or the best for "Share of the spread that a break lets through"].</source>
        <translation>Mindestbreite der Schneisen, aufgerundet auf ganze Zellen [sonst eine Zelle, oder die beste für "Anteil der Ausbreitung"].</translation>
    </message>
    <message>
        <source>Improve the breaks on simulated fires (takes longer)</source>
        <translation>Schneisen an simulierten Feuern verbessern (dauert länger)</translation>
    </message>
    <message>
        <source>Improve the breaks by local search on simulated fires; takes longer.</source>
        <translation>Verbessert die Schneisen durch örtliche Suche an simulierten Feuern; dauert länger.</translation>
    </message>
    <message>
        <source>Fires that the plan is made for</source>
        <translation>Feuer, für die der Plan gemacht wird</translation>
    </message>
    <message>
        <source>What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).</source>
        <translation>Was klein sein soll: der Verlust des mittleren Feuers, oder der des schlimmsten Zehntels der Feuer (CVaR).</translation>
    </message>
    <message>
        <source>The mean fire</source>
        <translation>Das mittlere Feuer</translation>
    </message>
    <message>
        <source>The worst tenth of the fires</source>
        <translation>Das schlimmste Zehntel der Feuer</translation>
    </message>
    <message>
        <source>Width of breaks that are lines [m]</source>
        <translation>Breite von Schneisen, die Linien sind [m]</translation>
    </message>
    <message>
        <source>Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length times their width. With "How often a break holds" flame, auto is the width with which fires take least. cells cuts whole cells, as in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.</source>
        <translation>Breite der Linien, aus denen Schneisen bestehen, z. B. 12m, auch schmaler als eine Zelle; das Budget zählt ihre Länge mal ihre Breite. Mit "Wie oft eine Schneise hält" flame ist auto die Breite, bei der Feuer am wenigsten nehmen. cells schneidet ganze Zellen wie im Artikel. Vorgabe: Linien so breit wie eine Zelle, höchstens 30 m, wo Feuer eine Uhr haben und Schneisen nicht durchlässig sind.</translation>
    </message>
    <message>
        <source>Treatments (CSV, or default)</source>
        <translation>Behandlungen (CSV, oder default)</translation>
    </message>
    <message>
        <source>Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires burn with what they leave [default: all segments alike, by "Share of the spread that a break lets through"].</source>
        <translation>Tabelle der Behandlungen (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), oder default: jedes Teilstück erhält die, die für ihre Kosten am meisten erspart, ein Budget in Geld ist, was sie kosten, und Feuer brennen mit dem, was sie übrig lassen [sonst alle Teilstücke gleich, nach "Anteil der Ausbreitung"].</translation>
    </message>
    <message>
        <source>as a word</source>
        <translation>als Wort</translation>
    </message>
    <message>
        <source>Breaks that stand already</source>
        <translation>Schneisen, die es schon gibt</translation>
    </message>
    <message>
        <source>Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.</source>
        <translation>Schneisen, die es schon gibt (Linien, Polygone oder ein Raster, von dem jedes zusammenhängende Stück eine ist): Feuer treffen sie mit und ohne Plan, sie versagen wie neue, und ihr Brennstoff wächst nach, wenn sie nicht gepflegt werden.</translation>
    </message>
    <message>
        <source>as polygons or lines</source>
        <translation>als Polygone oder Linien</translation>
    </message>
    <message>
        <source>Years of building and upkeep</source>
        <translation>Jahre des Baus und der Pflege</translation>
    </message>
    <message>
        <source>Number of years over which the breaks are built and kept up; 1: all is built at once.</source>
        <translation>Zahl der Jahre, über die die Schneisen gebaut und gepflegt werden; 1: alles wird auf einmal gebaut.</translation>
    </message>
    <message>
        <source>Budget of each year, such as 500ha</source>
        <translation>Budget jedes Jahres, z. B. 500ha</translation>
    </message>
    <message>
        <source>What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share [default: what all breaks cost, over the years].</source>
        <translation>Was jedes Jahr für Pflege, die zuerst bezahlt wird, und Bau erlaubt: 500ha, 20000eur oder ein Anteil [sonst, was alle Schneisen kosten, durch die Jahre].</translation>
    </message>
    <message>
        <source>Fires that start in a year</source>
        <translation>Feuer, die in einem Jahr entstehen</translation>
    </message>
    <message>
        <source>Number of fires that start in a year.</source>
        <translation>Zahl der Feuer, die in einem Jahr entstehen.</translation>
    </message>
    <message>
        <source>Discount rate a year, such as 3%</source>
        <translation>Abzinsung im Jahr, z. B. 3%</translation>
    </message>
    <message>
        <source>Rate a year, such as 3%, at which later costs and losses count less.</source>
        <translation>Satz im Jahr, z. B. 3%, mit dem spätere Kosten und Verluste weniger zählen.</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back</source>
        <translation>Jahre, bis behandelter Brennstoff nachgewachsen ist</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "Treatments", or agricultural=3,shrubs=4,pines=4, an assumption].</source>
        <translation>Jahre, bis behandelter Brennstoff nachgewachsen ist: 4, oder agricultural=3,shrubs=4,pines=8 [sonst die von "Behandlungen", oder agricultural=3,shrubs=4,pines=4, eine Annahme].</translation>
    </message>
    <message>
        <source>Cost of treating anew, as a share of treating first</source>
        <translation>Kosten erneuter Behandlung, als Anteil der ersten</translation>
    </message>
    <message>
        <source>What treating anew costs, as a share of treating first.</source>
        <translation>Was erneute Behandlung kostet, als Anteil der ersten.</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare</source>
        <translation>Schnittkosten je Hektar</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost", or classes such as agricultural=500,shrubs=900,pines=1500.</source>
        <translation>Schnittkosten je Hektar: ein Raster, Polygone mit "Feld mit den Kosten", oder Klassen wie agricultural=500,shrubs=900,pines=1500.</translation>
    </message>
    <message>
        <source>as classes: agricultural=500,pines=1500</source>
        <translation>als Klassen: agricultural=500,pines=1500</translation>
    </message>
    <message>
        <source>Field with the cost</source>
        <translation>Feld mit den Kosten</translation>
    </message>
    <message>
        <source>Column of the cost polygons.</source>
        <translation>Spalte der Kostenpolygone.</translation>
    </message>
    <message>
        <source>Cost per hectare where none is known</source>
        <translation>Kosten je Hektar, wo keine bekannt sind</translation>
    </message>
    <message>
        <source>Cost per hectare where "Cost of cutting per hectare" tells none; alone, everywhere [default: nothing is cut there].</source>
        <translation>Kosten je Hektar, wo "Schnittkosten je Hektar" keine nennt; allein überall [sonst wird dort nichts geschnitten].</translation>
    </message>
    <message>
        <source>Area outside of which nothing may be cut</source>
        <translation>Gebiet, außerhalb dessen nichts geschnitten werden darf</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.</source>
        <translation>Gebiet (Raster oder Polygone; Linien nehmen die Zellen, die sie berühren), außerhalb dessen nichts geschnitten werden darf.</translation>
    </message>
    <message>
        <source>Cells that protected and allowed areas keep</source>
        <translation>Zellen, die geschützte und erlaubte Gebiete behalten</translation>
    </message>
    <message>
        <source>Cells that "Area where nothing may be cut" and "Area outside of which nothing may be cut" keep from being cut: all with a part inside the one or outside the other, or those whose centre is.</source>
        <translation>Zellen, die "Gebiet" und "Gebiet" vor dem Schneiden bewahren: alle mit einem Teil in dem einen oder außerhalb des anderen, oder die, deren Mittelpunkt dort liegt.</translation>
    </message>
    <message>
        <source>Cells with any part in the area</source>
        <translation>Zellen, von denen ein Teil im Gebiet liegt</translation>
    </message>
    <message>
        <source>Cells whose centre is in the area</source>
        <translation>Zellen, deren Mittelpunkt im Gebiet liegt</translation>
    </message>
    <message>
        <source>Area of interest that is planned for</source>
        <translation>Gebiet, für das geplant wird</translation>
    </message>
    <message>
        <source>Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start and burn there too.</source>
        <translation>Gebiet (Raster oder Polygone), für das geplant wird: außerhalb wird nichts geschnitten, doch Feuer entstehen und brennen auch dort.</translation>
    </message>
    <message>
        <source>How much more a break counts in bad ground (0: all ground alike)</source>
        <translation>Wieviel mehr eine Schneise in schlechtem Gelände zählt (0: alles gleich)</translation>
    </message>
    <message>
        <source>How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].</source>
        <translation>Wieviel mehr eine Schneise im schlechtesten Gelände zählt als auf einem Kamm, an einer Straße, einem Fluss oder am Rand des Brennstoffs; 0: alles Gelände gleich, wie im Artikel [Vorgabe: 1.5, wo das Gelände bekannt ist und Relief hat].</translation>
    </message>
    <message>
        <source>Steeper ground is not cut [degrees]</source>
        <translation>Steileres Gelände wird nicht geschnitten [Grad]</translation>
    </message>
    <message>
        <source>Ground that is steeper is not cut.</source>
        <translation>Gelände, das steiler ist, wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>Cut only within this distance of roads, such as 200m</source>
        <translation>Nur so nah an Straßen schneiden, z. B. 200m</translation>
    </message>
    <message>
        <source>Only ground within this of a road is cut: 200m.</source>
        <translation>Nur Gelände in dieser Entfernung von einer Straße wird geschnitten: 200m.</translation>
    </message>
    <message>
        <source>Cut nothing within this distance of roads, such as 50m</source>
        <translation>So nah an Straßen nichts schneiden, z. B. 50m</translation>
    </message>
    <message>
        <source>Ground within this of a road is not cut: 50m.</source>
        <translation>Gelände in dieser Entfernung von einer Straße wird nicht geschnitten: 50m.</translation>
    </message>
    <message>
        <source>Fire breaks</source>
        <translation>Brandschneisen</translation>
    </message>
    <message>
        <source>Fire breaks as polygons</source>
        <translation>Brandschneisen als Polygone</translation>
    </message>
    <message>
        <source>Segments to build, in order</source>
        <translation>Zu bauende Teilstücke, der Reihe nach</translation>
    </message>
    <message>
        <source>Compartments between the breaks</source>
        <translation>Brandabschnitte zwischen den Schneisen</translation>
    </message>
    <message>
        <source>The plan on one page: map, segments, doubt; opens in any browser</source>
        <translation>Der Plan auf einer Seite: Karte, Teilstücke, Unsicherheit; öffnet sich in jedem Browser</translation>
    </message>
    <message>
        <source>Cutting priority</source>
        <translation>Schnittpriorität</translation>
    </message>
    <message>
        <source>What each cell would keep of its spread once treated</source>
        <translation>Was jede Zelle behandelt von ihrer Ausbreitung behielte</translation>
    </message>
    <message>
        <source>Burn frequency without breaks</source>
        <translation>Brandhäufigkeit ohne Schneisen</translation>
    </message>
    <message>
        <source>Burn frequency with the breaks</source>
        <translation>Brandhäufigkeit mit den Schneisen</translation>
    </message>
    <message>
        <source>Existing breaks, what each is worth, and whether it is kept up</source>
        <translation>Vorhandene Schneisen, was jede wert ist und ob sie gepflegt wird</translation>
    </message>
    <message>
        <source>What the plan does for its goal and for all others</source>
        <translation>Was der Plan für sein Ziel und für alle anderen leistet</translation>
    </message>
    <message>
        <source>What is built, kept up and burnt in each year</source>
        <translation>Was in jedem Jahr gebaut, gepflegt und verbrannt wird</translation>
    </message>
    <message>
        <source>Size of every fire without and with the breaks</source>
        <translation>Größe jedes Feuers ohne und mit den Schneisen</translation>
    </message>
    <message>
        <source>Burnt share at every budget</source>
        <translation>Verbrannter Anteil bei jedem Budget</translation>
    </message>
    <message>
        <source>Cells burnt in every run of it</source>
        <translation>Verbrannte Zellen in jedem Lauf dazu</translation>
    </message>
    <message>
        <source>Burnt share at every budget, without a clock and with perfect breaks</source>
        <translation>Verbrannter Anteil bei jedem Budget, ohne Zeit und mit vollkommenen Schneisen</translation>
    </message>
    <message>
        <source>Picture of the plan</source>
        <translation>Bild des Plans</translation>
    </message>
    <message>
        <source>Rank cells</source>
        <translation>Zellen reihen</translation>
    </message>
    <message>
        <source>Rank the cells of a spread network by the order in which they should be cut: higher is earlier.</source>
        <translation>Reiht die Zellen eines Ausbreitungsnetzes in der Folge, in der sie zu schneiden sind: höher ist früher.</translation>
    </message>
    <message>
        <source>Rankings that lay a pattern for the budget give another order for another budget.</source>
        <translation>Rangfolgen, die für das Budget ein Muster legen, ergeben für ein anderes Budget eine andere Folge.</translation>
    </message>
    <message>
        <source>Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.</source>
        <translation>Acht Kanäle mit der Wahrscheinlichkeit, dass Feuer nach N, NO, O, SO, S, SW, W und NW übergreift.</translation>
    </message>
    <message>
        <source>Elevation, for methods that follow ridges [m].</source>
        <translation>Höhe, für Methoden, die Kämmen folgen [m].</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: alike].</source>
        <translation>Wie wahrscheinlich ein Feuer in jeder Zelle entsteht, im Verhältnis zu den anderen [sonst gleich].</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost".</source>
        <translation>Schnittkosten je Hektar: ein Raster, Polygone mit "Feld mit den Kosten".</translation>
    </message>
    <message>
        <source>Select fire breaks</source>
        <translation>Brandschneisen auswählen</translation>
    </message>
    <message>
        <source>Cut the cells of highest priority, as many as the budget allows.</source>
        <translation>Schneidet die Zellen mit der höchsten Priorität, so viele das Budget erlaubt.</translation>
    </message>
    <message>
        <source>Ties are cut by row, then column. A priority that was made for another budget is warned of.</source>
        <translation>Bei Gleichstand wird nach Zeile, dann Spalte geschnitten. Vor einer Priorität, die für ein anderes Budget gemacht wurde, wird gewarnt.</translation>
    </message>
    <message>
        <source>Score by which cells are cut, higher is earlier.</source>
        <translation>Zahl, nach der Zellen geschnitten werden, höher ist früher.</translation>
    </message>
    <message>
        <source>Cost per hectare, for budgets of money: a raster, or polygons with "Field with the cost".</source>
        <translation>Kosten je Hektar, für Budgets in Geld: ein Raster, oder Polygone mit "Feld mit den Kosten".</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority</source>
        <translation>Ein Raster nehmen, das nicht als Priorität geschrieben wurde</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority all the same: its greatest numbers are cut first.</source>
        <translation>Nimmt ein Raster, das nicht als Priorität geschrieben wurde, trotzdem: seine größten Zahlen werden zuerst geschnitten.</translation>
    </message>
    <message>
        <source>Segments to build</source>
        <translation>Zu bauende Teilstücke</translation>
    </message>
    <message>
        <source>Take fire breaks apart into segments to build, best first.</source>
        <translation>Zerlegt Brandschneisen in Teilstücke, die zu bauen sind, die besten zuerst.</translation>
    </message>
    <message>
        <source>Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope and cost, and the share of all that the breaks save that it adds.</source>
        <translation>Jedes Teilstück trennt zwei Brandabschnitte und hat eine Baufolge, Länge, Breite, Fläche, mittlere Neigung und Kosten sowie den Anteil, den es zur gesamten Ersparnis der Schneisen beiträgt.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Teilstücke</translation>
    </message>
    <message>
        <source>Stages of construction</source>
        <translation>Baustufen</translation>
    </message>
    <message>
        <source>Length in kilometres</source>
        <translation>Länge in Kilometern</translation>
    </message>
    <message>
        <source>Cells that are cut: 1, all others 0.</source>
        <translation>Zellen, die geschnitten sind: 1, alle anderen 0.</translation>
    </message>
    <message>
        <source>Ranking; decides between segments that save equally much.</source>
        <translation>Rangfolge; entscheidet zwischen Teilstücken, die gleich viel ersparen.</translation>
    </message>
    <message>
        <source>Elevation on any grid, for the slopes [m].</source>
        <translation>Höhe auf beliebigem Gitter, für die Neigungen [m].</translation>
    </message>
    <message>
        <source>What of the segments goes into a format with one layer</source>
        <translation>Was von den Teilstücken in ein Format mit einem Layer kommt</translation>
    </message>
    <message>
        <source>Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].</source>
        <translation>Layer der Teilstücke, der geschrieben wird: Mittellinien oder Umrisse [sonst beide in .gpkg, in anderen die Linien].</translation>
    </message>
    <message>
        <source>Their middle lines</source>
        <translation>Ihre Mittellinien</translation>
    </message>
    <message>
        <source>Their outlines</source>
        <translation>Ihre Umrisse</translation>
    </message>
    <message>
        <source>Map book for crews</source>
        <translation>Kartenbuch für die Trupps</translation>
    </message>
    <message>
        <source>Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, its ends, sizes, slope, cost and treatment, and what it is for.</source>
        <translation>Druckt einen Plan als PDF: eine Übersicht, eine Liste der Teilstücke und für jedes eine Seite mit einer Karte in rundem Maßstab, seinen Enden, Maßen, Neigung, Kosten und Behandlung, und wozu er dient.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the plan were written. Its segments alone do as well, without the vegetation; then the elevation is asked for.</source>
        <translation>Wählen Sie den Ordner, in den alle Dateien des Plans geschrieben wurden. Seine Teilstücke allein genügen auch, ohne die Vegetation; dann wird nach der Höhe gefragt.</translation>
    </message>
    <message>
        <source>Segments with a page</source>
        <translation>Teilstücke mit eigener Seite</translation>
    </message>
    <message>
        <source>Folder of the run</source>
        <translation>Ordner des Laufs</translation>
    </message>
    <message>
        <source>Into which a plan or a comparison was written with all its files.</source>
        <translation>In den ein Plan oder Vergleich mit allen seinen Dateien geschrieben wurde.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Title of the book [default: what the plan says of itself].</source>
        <translation>Titel des Buches [Vorgabe: was der Plan von sich sagt].</translation>
    </message>
    <message>
        <source>Date, as it is to be shown</source>
        <translation>Datum, wie es erscheinen soll</translation>
    </message>
    <message>
        <source>Date of the data or the print, shown as it is given.</source>
        <translation>Datum der Daten oder des Drucks; es erscheint, wie es angegeben wird.</translation>
    </message>
    <message>
        <source>Roads to draw: lines or areas of any vector file.</source>
        <translation>Straßen, die gezeichnet werden: Linien oder Flächen einer beliebigen Vektordatei.</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw</source>
        <translation>Flüsse und Seen zum Zeichnen</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw: lines or areas.</source>
        <translation>Flüsse und Seen, die gezeichnet werden: Linien oder Flächen.</translation>
    </message>
    <message>
        <source>Most segments that get a page</source>
        <translation>Höchstzahl der Teilstücke mit eigener Seite</translation>
    </message>
    <message>
        <source>Segments that get a page, the first in order of construction; the list names all.</source>
        <translation>Teilstücke, die eine Seite bekommen, die ersten in der Reihenfolge des Baus; die Liste nennt alle.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Size of the paper.</source>
        <translation>Größe des Papiers.</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>as its segments (segments.gpkg)</source>
        <translation>als seine Teilstücke (segments.gpkg)</translation>
    </message>
    <message>
        <source>Elevation on any grid, beside segments alone; the folder of a plan has its own.</source>
        <translation>Höhe auf beliebigem Gitter, wenn nur Teilstücke gegeben sind; der Ordner eines Plans hat seine eigene.</translation>
    </message>
    <message>
        <source>Shorter segments get no page [m]</source>
        <translation>Kürzere Teilstücke bekommen keine Seite [m]</translation>
    </message>
    <message>
        <source>Segments shorter than this have no page of their own [m].</source>
        <translation>Teilstücke, die kürzer sind, haben keine eigene Seite [m].</translation>
    </message>
    <message>
        <source>Upright pages</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Upright pages, the texts under the map.</source>
        <translation>Seiten im Hochformat, die Texte unter der Karte.</translation>
    </message>
    <message>
        <source>Map book</source>
        <translation>Kartenbuch</translation>
    </message>
    <message>
        <source>Files for crews</source>
        <translation>Dateien für die Trupps</translation>
    </message>
    <message>
        <source>Write segments, breaks or compartments of a plan in the format of a crew.</source>
        <translation>Schreibt Teilstücke, Brandschneisen oder Brandabschnitte eines Plans in dem Format eines Trupps.</translation>
    </message>
    <message>
        <source>The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, .zip for a Shapefile, .geojson for the web.</source>
        <translation>Die Endung der Datei bestimmt es: .kml für Google Earth und Telefone, .gpx für GPS-Geräte, .dxf für Zeichnungen, .zip für ein Shapefile, .geojson für das Web.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Segments, breaks or compartments of a plan (.gpkg)</source>
        <translation>Teilstücke, Brandschneisen oder Brandabschnitte eines Plans (.gpkg)</translation>
    </message>
    <message>
        <source>The segments.gpkg, breaks.gpkg or compartments.gpkg that a plan wrote.</source>
        <translation>Die segments.gpkg, breaks.gpkg oder compartments.gpkg, die ein Plan geschrieben hat.</translation>
    </message>
    <message>
        <source>File for the crew</source>
        <translation>Datei für den Trupp</translation>
    </message>
    <message>
        <source>Burn frequency</source>
        <translation>Brandhäufigkeit</translation>
    </message>
    <message>
        <source>Let many fires start and tell how often each cell burns.</source>
        <translation>Lässt viele Feuer entstehen und sagt, wie oft jede Zelle brennt.</translation>
    </message>
    <message>
        <source>Fires with a duration need a network with times. With the same seed the fires are the same with and without breaks, so their difference is the breaks' work alone.</source>
        <translation>Feuer mit einer Dauer brauchen ein Netz mit Zeiten. Mit demselben Startwert sind die Feuer mit und ohne Schneisen dieselben, ihr Unterschied ist also allein das Werk der Schneisen.</translation>
    </message>
    <message>
        <source>Mean burnt share</source>
        <translation>Mittlerer verbrannter Anteil</translation>
    </message>
    <message>
        <source>Largest burnt share</source>
        <translation>Größter verbrannter Anteil</translation>
    </message>
    <message>
        <source>Mean fire in hectares</source>
        <translation>Mittleres Feuer in Hektar</translation>
    </message>
    <message>
        <source>Largest fire in hectares</source>
        <translation>Größtes Feuer in Hektar</translation>
    </message>
    <message>
        <source>Cut cells: a raster, or own breaks as polygons or lines.</source>
        <translation>Geschnittene Zellen: ein Raster, oder eigene Schneisen als Polygone oder Linien.</translation>
    </message>
    <message>
        <source>Roads, rivers and the like on ground that the network holds as fuel; they stop fire as "How often a barrier holds" says.</source>
        <translation>Straßen, Flüsse und dergleichen auf Boden, der im Netz Brennstoff ist; sie halten Feuer auf, wie "Wie oft eine Barriere hält" sagt.</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: until they end by themselves].</source>
        <translation>Wie lange Feuer brennen: 8h, eine Liste, die die Läufe der Reihe nach nehmen (4h,8h), lognormal:8h,0.7 (Median und Sigma), uniform:2h,12h, oder weather [sonst, bis sie von selbst enden].</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: always].</source>
        <translation>Wie oft ein Stück Schneise in einem Lauf hält: ein Anteil (0.47 im Gelände), flame (nach Breite und Intensität des Feuers, Wilson 1988) oder flame:flames (1.5 Flammenlängen); Stücke haben 400 m, oder wie in 0.47:800 [sonst immer].</translation>
    </message>
    <message>
        <source>Take "Fire breaks" as lines of this width, such as 12m, or of the width in that column; they may be narrower than a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].</source>
        <translation>Nimmt "Brandschneisen" als Linien dieser Breite, z. B. 12m, oder der Breite in dieser Spalte; sie dürfen schmaler als eine Zelle sein und halten Feuer zwischen den Zellen auf, die sie trennen [sonst nehmen Linien jede Zelle, die sie berühren].</translation>
    </message>
    <message>
        <source>What treated cells keep of their spread (kept.tif)</source>
        <translation>Was behandelte Zellen von ihrer Ausbreitung behalten (kept.tif)</translation>
    </message>
    <message>
        <source>What each cell keeps of its spread probability once it is treated, in place of one "Share of the spread that a break lets through" for all: kept.tif of a plan with treatments.</source>
        <translation>Was jede Zelle von ihrer Ausbreitungswahrscheinlichkeit behält, wenn sie behandelt ist, statt eines "Anteil der Ausbreitung" für alle: kept.tif eines Plans mit Behandlungen.</translation>
    </message>
    <message>
        <source>Side of the windows in which a large map is read [cells]</source>
        <translation>Seite der Fenster, in denen eine große Karte gelesen wird [Zellen]</translation>
    </message>
    <message>
        <source>Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire needs it, so that maps larger than the memory can burn; the fires are the same.</source>
        <translation>Liest die Karte in Fenstern dieser Seite (eine Zweierpotenz, z. B. 512) um jedes Feuer, größer, wo ein Feuer es braucht, damit auch Karten brennen können, die größer als der Speicher sind; die Feuer sind dieselben.</translation>
    </message>
    <message>
        <source>Times for the folder of arrival times, such as 2h,4h</source>
        <translation>Zeiten für den Ordner der Ankunftszeiten, z. B. 2h,4h</translation>
    </message>
    <message>
        <source>Times for "Folder for arrival times".</source>
        <translation>Zeiten für "Ordner für Ankunftszeiten".</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes [hectares]</source>
        <translation>Grenzen der Größenklassen der Feuer [Hektar]</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes for "Folder for arrival times", in hectares.</source>
        <translation>Grenzen der Größenklassen der Feuer für "Ordner für Ankunftszeiten", in Hektar.</translation>
    </message>
    <message>
        <source>Flame lengths for the folder of arrival times [m]</source>
        <translation>Flammenlängen für den Ordner der Ankunftszeiten [m]</translation>
    </message>
    <message>
        <source>Flame lengths for "Folder for arrival times", in metres; left out if the network knows no heat.</source>
        <translation>Flammenlängen für "Ordner für Ankunftszeiten", in Metern; entfallen, wenn das Netz keine Wärme kennt.</translation>
    </message>
    <message>
        <source>Fire sizes</source>
        <translation>Feuergrößen</translation>
    </message>
    <message>
        <source>Folder for arrival times, isochrones and more</source>
        <translation>Ordner für Ankunftszeiten, Isochronen und mehr</translation>
    </message>
    <message>
        <source>Judge existing breaks</source>
        <translation>Vorhandene Schneisen beurteilen</translation>
    </message>
    <message>
        <source>Tell what each existing fire break is worth, and which gap between breaks matters most.</source>
        <translation>Sagt, was jede vorhandene Brandschneise wert ist und welche Lücke zwischen Schneisen am meisten zählt.</translation>
    </message>
    <message>
        <source>The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are the work of that break alone. The same break at random places stands beside it. The network must hold the fuel that lies on the breaks.</source>
        <translation>Dieselben Feuer brennen mit allen Schneisen, ohne jede von ihnen und mit jeder geschlossenen Lücke, die Unterschiede sind also das Werk dieser Schneise allein. Daneben steht dieselbe Schneise an zufälligen Orten. Das Netz muss den Brennstoff enthalten, der auf den Schneisen liegt.</translation>
    </message>
    <message>
        <source>Longest gap that is looked at [m]</source>
        <translation>Längste Lücke, die betrachtet wird [m]</translation>
    </message>
    <message>
        <source>Length of the longest gap that is looked at, in metres.</source>
        <translation>Länge der längsten Lücke, die betrachtet wird, in Metern.</translation>
    </message>
    <message>
        <source>Most gaps that are looked at</source>
        <translation>Höchstzahl betrachteter Lücken</translation>
    </message>
    <message>
        <source>Number of gaps looked at, the shortest.</source>
        <translation>Zahl der betrachteten Lücken, die kürzesten.</translation>
    </message>
    <message>
        <source>Random places to compare each break with</source>
        <translation>Zufällige Orte, mit denen jede Schneise verglichen wird</translation>
    </message>
    <message>
        <source>Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.</source>
        <translation>Zahl zufälliger Orte, an denen jede Schneise und Lücke zum Vergleich ebenfalls versucht wird; 0 lässt sie weg.</translation>
    </message>
    <message>
        <source>Breaks with what each is worth, and gaps with what closing them saves</source>
        <translation>Schneisen mit dem, was jede wert ist, und Lücken mit dem, was ihr Schließen erspart</translation>
    </message>
    <message>
        <source>What each break is worth</source>
        <translation>Was jede Schneise wert ist</translation>
    </message>
    <message>
        <source>What closing each gap saves</source>
        <translation>Was das Schließen jeder Lücke erspart</translation>
    </message>
    <message>
        <source>What stands and what is missing, in words</source>
        <translation>Was steht und was fehlt, in Worten</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.</source>
        <translation>Beurteilt Rangfolgen: Mittel, 90-%-Perzentil und Maximum des verbrannten Anteils bei jedem Budget.</translation>
    </message>
    <message>
        <source>All rankings meet the same fires, and each plan is made for its budget.</source>
        <translation>Alle Rangfolgen treffen auf dieselben Feuer, und jeder Plan ist für sein Budget gemacht.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Methoden</translation>
    </message>
    <message>
        <source>Methods to hold against each other; all rankings are described below.</source>
        <translation>Methoden, die gegeneinander gehalten werden; alle Rangfolgen sind unten beschrieben.</translation>
    </message>
    <message>
        <source>Ranking to test against</source>
        <translation>Rangfolge, gegen die getestet wird</translation>
    </message>
    <message>
        <source>Ranking that the others are tested against.</source>
        <translation>Rangfolge, gegen die die anderen getestet werden.</translation>
    </message>
    <message>
        <source>Budgets, such as 5%, 10%</source>
        <translation>Budgets, z. B. 5%, 10%</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: 0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</source>
        <translation>Wie viel geschnitten wird, durch Kommas getrennt: Anteile des Brennstoffs wie 5% oder 0.05, oder Flächen wie 20ha [sonst 0 bis 0.4 in Schritten von 0.01; wo jedes Budget neu gebrannt wird, mit Zeit oder Schneisen, die versagen, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test für Paare, Wilcoxon-Rangsummentest für unabhängige Läufe, oder t-Test für Paare.</translation>
    </message>
    <message>
        <source>Wilcoxon's signed-rank test of pairs</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test für Paare</translation>
    </message>
    <message>
        <source>Wilcoxon's rank-sum test of independent runs</source>
        <translation>Wilcoxon-Rangsummentest für unabhängige Läufe</translation>
    </message>
    <message>
        <source>Student's t-test of pairs</source>
        <translation>Students t-Test für Paare</translation>
    </message>
    <message>
        <source>Significance threshold</source>
        <translation>Signifikanzschwelle</translation>
    </message>
    <message>
        <source>Significance threshold.</source>
        <translation>Signifikanzschwelle.</translation>
    </message>
    <message>
        <source>Burnt share and significance of every ranking at every budget</source>
        <translation>Verbrannter Anteil und Signifikanz jeder Rangfolge bei jedem Budget</translation>
    </message>
    <message>
        <source>Cells burnt in every run, from which each p-value can be found again</source>
        <translation>Verbrannte Zellen in jedem Lauf, aus denen sich jeder p-Wert wiederfinden lässt</translation>
    </message>
    <message>
        <source>Curves of the burnt share</source>
        <translation>Kurven des verbrannten Anteils</translation>
    </message>
    <message>
        <source>Curves of the burnt share, to scale</source>
        <translation>Kurven des verbrannten Anteils, skalierbar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with intervals.</source>
        <translation>Vergleicht Pläne: erwartete Brandfläche, verlorener Wert, schlimmste Feuer und gerettete Hektar je geschnittenem Hektar, mit Intervallen.</translation>
    </message>
    <message>
        <source>The fires are fresh: no plan was designed with them, and all burn in the same ones.</source>
        <translation>Die Feuer sind frisch: kein Plan wurde mit ihnen entworfen, und alle brennen in denselben.</translation>
    </message>
    <message>
        <source>Lines: walls as wide as a cell and at most 30 m, of which plans are made by default</source>
        <translation>Linien: Wände so breit wie eine Zelle und höchstens 30 m, aus denen Pläne bestehen, wo nichts gesagt ist</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.</source>
        <translation>Wie viel geschnitten wird, durch Kommas getrennt: Anteile des Brennstoffs wie 5% oder 0.05, oder Flächen wie 20ha.</translation>
    </message>
    <message>
        <source>Shares that breaks let through, separated by commas</source>
        <translation>Anteile, die Schneisen durchlassen, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.</source>
        <translation>Anteile seiner Ausbreitungswahrscheinlichkeit, die eine behandelte Zelle behält, durch Kommas getrennt; 0 ist vollkommen.</translation>
    </message>
    <message>
        <source>Fires expected until the breaks have grown back</source>
        <translation>Feuer, die erwartet werden, bis die Schneisen zugewachsen sind</translation>
    </message>
    <message>
        <source>Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so often when it is held against what they cost.</source>
        <translation>Zahl der Feuer, die auf die Schneisen treffen, bevor sie zugewachsen sind; was Schneisen in einem Feuer ersparen, zählt so oft, wenn es gegen ihre Kosten gehalten wird.</translation>
    </message>
    <message>
        <source>The comparison on one page; opens in any browser</source>
        <translation>Der Vergleich auf einer Seite; öffnet sich in jedem Browser</translation>
    </message>
    <message>
        <source>Every plan at every budget and leak, with intervals</source>
        <translation>Jeder Plan bei jedem Budget und jeder Durchlässigkeit, mit Intervallen</translation>
    </message>
    <message>
        <source>Curves of the plans</source>
        <translation>Kurven der Pläne</translation>
    </message>
    <message>
        <source>Curves of the plans, to scale</source>
        <translation>Kurven der Pläne, skalierbar</translation>
    </message>
    <message>
        <source>What each step of each plan costs and saves</source>
        <translation>Was jeder Schritt jedes Plans kostet und erspart</translation>
    </message>
    <message>
        <source>Saved against paid, and where the next hectare stops paying</source>
        <translation>Erspartes gegen Bezahltes, und wo sich der nächste Hektar nicht mehr lohnt</translation>
    </message>
    <message>
        <source>Validate against a scar</source>
        <translation>An einer Brandfläche prüfen</translation>
    </message>
    <message>
        <source>Hold a simulated fire against the area that burnt, beside fires that know nothing.</source>
        <translation>Hält ein simuliertes Feuer gegen die verbrannte Fläche, neben Feuern, die nichts wissen.</translation>
    </message>
    <message>
        <source>Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.</source>
        <translation>Sørensen-Index, IoU, IoU des Zuwachses allein, Größe, Brier-Wert und Verlässlichkeit werden für das simulierte Feuer und für die Nullmodelle angegeben: kein Zuwachs, gleicher Abstand im Brennstoff, eine Ellipse im Wind.</translation>
    </message>
    <message>
        <source>Observed hectares</source>
        <translation>Beobachtete Hektar</translation>
    </message>
    <message>
        <source>Simulated hectares</source>
        <translation>Simulierte Hektar</translation>
    </message>
    <message>
        <source>Area that burnt</source>
        <translation>Verbrannte Fläche</translation>
    </message>
    <message>
        <source>Perimeter of the fire as polygons, or a raster above 0 where it burnt.</source>
        <translation>Umriss des Feuers als Polygone, oder ein Raster über 0, wo es brannte.</translation>
    </message>
    <message>
        <source>Where the fire was first seen</source>
        <translation>Wo das Feuer zuerst gesehen wurde</translation>
    </message>
    <message>
        <source>Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.</source>
        <translation>Wo das Feuer zuerst gesehen wurde: Punkte, oder Polygone, die schon brannten (jede Vektordatei), oder ein Raster.</translation>
    </message>
    <message>
        <source>How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.</source>
        <translation>Wie lange sich das Feuer ausbreitete, z. B. 3h; lognormal:3h,0.5 (Median, Sigma), wo das nicht gut bekannt ist.</translation>
    </message>
    <message>
        <source>Number of simulated fires.</source>
        <translation>Anzahl der simulierten Feuer.</translation>
    </message>
    <message>
        <source>Scores of the simulated fire and of the null models</source>
        <translation>Werte des simulierten Feuers und der Nullmodelle</translation>
    </message>
    <message>
        <source>How often cells burnt, by the probability forecast</source>
        <translation>Wie oft Zellen brannten, nach der vorhergesagten Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Share of the simulated fires in which each cell burns</source>
        <translation>Anteil der simulierten Feuer, in denen jede Zelle brennt</translation>
    </message>
    <message>
        <source>Picture of the simulated fire over the scar, with the reliability</source>
        <translation>Bild des simulierten Feuers über der Brandfläche, mit der Verlässlichkeit</translation>
    </message>
    <message>
        <source>Calibrate on observed fires</source>
        <translation>An beobachteten Feuern kalibrieren</translation>
    </message>
    <message>
        <source>Fit the rate of spread, durations and spread probability to the fires of a region.</source>
        <translation>Passt Ausbreitungsgeschwindigkeit, Dauern und Ausbreitungswahrscheinlichkeit an die Feuer einer Region an.</translation>
    </message>
    <message>
        <source>The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in which they burn. More numbers than the fires can tell are refused.</source>
        <translation>Die Feuer sind Polygone oder eine Tabelle mit ihren Größen und, wenn bekannt, ihren Tagen; das Wetter nennt die Winde, in denen sie brennen. Mehr Zahlen, als die Feuer hergeben, werden zurückgewiesen.</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Feuer</translation>
    </message>
    <message>
        <source>Numbers fitted</source>
        <translation>Angepasste Zahlen</translation>
    </message>
    <message>
        <source>Observed fires with sizes and days</source>
        <translation>Beobachtete Feuer mit Größen und Tagen</translation>
    </message>
    <message>
        <source>Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.</source>
        <translation>Polygone oder eine Tabelle (CSV) der Feuer einer Region, mit ihren Größen in Hektar und, wenn bekannt, ihren Tagen.</translation>
    </message>
    <message>
        <source>What to fit: rate, duration, p0</source>
        <translation>Was anzupassen ist: rate, duration, p0</translation>
    </message>
    <message>
        <source>What to fit: rate, duration and p0, separated by commas [default: rate and duration; of fewer than three scars the rate alone].</source>
        <translation>Was anzupassen ist: rate, duration und p0, durch Kommas getrennt [sonst rate und duration; bei weniger als drei Brandflächen rate allein].</translation>
    </message>
    <message>
        <source>Smallest fire that counts [hectares]</source>
        <translation>Kleinstes Feuer, das zählt [Hektar]</translation>
    </message>
    <message>
        <source>Fires of fewer hectares do not count: small ones are often not mapped.</source>
        <translation>Feuer mit weniger Hektar zählen nicht: kleine sind oft nicht kartiert.</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: everywhere alike].</source>
        <translation>Wie wahrscheinlich ein Feuer in jeder Zelle entsteht, im Verhältnis zu den anderen [sonst überall gleich].</translation>
    </message>
    <message>
        <source>Column with the size in hectares</source>
        <translation>Spalte mit der Größe in Hektar</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the size in hectares [default: found by name].</source>
        <translation>Spalte von "Beobachtete Feuer mit Größen und Tagen" mit der Größe in Hektar [sonst am Namen erkannt].</translation>
    </message>
    <message>
        <source>Column with the first day</source>
        <translation>Spalte mit dem ersten Tag</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the first day [default: found by name].</source>
        <translation>Spalte von "Beobachtete Feuer mit Größen und Tagen" mit dem ersten Tag [sonst am Namen erkannt].</translation>
    </message>
    <message>
        <source>Column with the last day</source>
        <translation>Spalte mit dem letzten Tag</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the last day [default: found by name].</source>
        <translation>Spalte von "Beobachtete Feuer mit Größen und Tagen" mit dem letzten Tag [sonst am Namen erkannt].</translation>
    </message>
    <message>
        <source>Time of spread on each day of a fire [hours]</source>
        <translation>Ausbreitungszeit an jedem Tag eines Feuers [Stunden]</translation>
    </message>
    <message>
        <source>Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.</source>
        <translation>Stunden, die sich ein Feuer an jedem seiner Tage ausbreitet; eine Annahme, die Geschwindigkeiten und Dauern trennt.</translation>
    </message>
    <message>
        <source>Longest simulated fire, such as 200h</source>
        <translation>Längstes simuliertes Feuer, z. B. 200h</translation>
    </message>
    <message>
        <source>No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].</source>
        <translation>Kein Feuer breitet sich länger aus [sonst so viele ganze Tage wie das längste beobachtete Feuer, oder 200h].</translation>
    </message>
    <message>
        <source>Parameter of the spread model that stays as it is, e.g. moisture=0.06; several are separated by ;.</source>
        <translation>Parameter des Ausbreitungsmodells, der bleibt, wie er ist, z. B. moisture=0.06; mehrere durch ; getrennt.</translation>
    </message>
    <message>
        <source>Calibration, which other forms take</source>
        <translation>Kalibrierung, die andere Formulare nehmen</translation>
    </message>
    <message>
        <source>What is told of each fire</source>
        <translation>Was über jedes Feuer gesagt wird</translation>
    </message>
    <message>
        <source>Report of a run</source>
        <translation>Bericht eines Laufs</translation>
    </message>
    <message>
        <source>Show a plan or a comparison on one page: map, segments, curve, assumptions, files.</source>
        <translation>Zeigt einen Plan oder Vergleich auf einer Seite: Karte, Teilstücke, Kurve, Annahmen, Dateien.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the run were written. The page opens in any browser without a network. Its links lead to files beside the page, so write it into that folder.</source>
        <translation>Wählen Sie den Ordner, in den alle Dateien des Laufs geschrieben wurden. Die Seite öffnet sich in jedem Browser ohne Netzwerk. Ihre Verweise führen zu Dateien neben der Seite; schreiben Sie sie also in diesen Ordner.</translation>
    </message>
    <message>
        <source>The run on one page</source>
        <translation>Der Lauf auf einer Seite</translation>
    </message>
    <message>
        <source>{} was not made: there is nothing to put in it.</source>
        <translation>{} wurde nicht gemacht: es gibt nichts, was hineinkäme.</translation>
    </message>
    <message>
        <source>Stopped; no output was written.</source>
        <translation>Angehalten; keine Ausgabe wurde geschrieben.</translation>
    </message>
    <message>
        <source>Report: {} (open it from the Results Viewer)</source>
        <translation>Bericht: {} (aus der Ergebnisanzeige zu öffnen)</translation>
    </message>
    <message>
        <source>[not chosen]</source>
        <translation>[nicht gewählt]</translation>
    </message>
    <message>
        <source>{} holds {}; only a GeoPackage can hold {} as well.</source>
        <translation>{} enthält {}; nur ein GeoPackage kann auch {} enthalten.</translation>
    </message>
    <message>
        <source>The layer {} cannot be read as cells of a raster.</source>
        <translation>Der Layer {} lässt sich nicht als Zellen eines Rasters lesen.</translation>
    </message>
    <message>
        <source>An extent needs the CRS of the grid; choose it beside the extent (CRS).</source>
        <translation>Eine Ausdehnung braucht das KBS des Gitters; wählen Sie es neben der Ausdehnung (KBS).</translation>
    </message>
    <message>
        <source>Making the engine of Firebreak</source>
        <translation>Die Rechenumgebung von Firebreak wird gemacht</translation>
    </message>
    <message>
        <source>firebreak_gis {} is ready.</source>
        <translation>firebreak_gis {} ist bereit.</translation>
    </message>
    <message>
        <source>firebreak_gis {} answers: {} ({})</source>
        <translation>firebreak_gis {} antwortet: {} ({})</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Rechenumgebung</translation>
    </message>
    <message>
        <source>Python with firebreak_gis, or the firebreak program</source>
        <translation>Python mit firebreak_gis, oder das Programm firebreak</translation>
    </message>
    <message>
        <source>empty: found by itself</source>
        <translation>leer: wird von selbst gefunden</translation>
    </message>
    <message>
        <source>Python or program</source>
        <translation>Python oder Programm</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Make an engine</source>
        <translation>Eine Rechenumgebung machen</translation>
    </message>
    <message>
        <source>Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The Python of QGIS is left alone, and an engine made before stays until the new one answers. Nothing is installed until you press the button.</source>
        <translation>Macht eine Python-Umgebung in Ihrem QGIS-Profil, etwa 900 MB, und installiert firebreak_gis darin: aus dem Paketverzeichnis (über den Proxy von QGIS), oder vom Pfad eines Klons oder Wheels. Das Python von QGIS bleibt unberührt, und eine früher gemachte Umgebung bleibt, bis die neue antwortet. Nichts wird installiert, bevor Sie den Knopf drücken.</translation>
    </message>
    <message>
        <source>empty: the newest of 3.11 to 3.13 found</source>
        <translation>leer: das neueste gefundene von 3.11 bis 3.13</translation>
    </message>
    <message>
        <source>Python to make it from</source>
        <translation>Python, aus dem sie gemacht wird</translation>
    </message>
    <message>
        <source>A name in the index, or the path of a clone or a wheel.</source>
        <translation>Ein Name im Paketverzeichnis, oder der Pfad eines Klons oder Wheels.</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Paket</translation>
    </message>
    <message>
        <source>Make engine</source>
        <translation>Rechenumgebung machen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Firebreak settings…</source>
        <translation>Einstellungen von Firebreak…</translation>
    </message>
    <message>
        <source>Firebreak</source>
        <translation>Firebreak</translation>
    </message>
    <message>
        <source>Firebreak (plan forest fire breaks)</source>
        <translation>Firebreak (Brandschneisen im Wald planen)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgaben</translation>
    </message>
</context>
</TS>
