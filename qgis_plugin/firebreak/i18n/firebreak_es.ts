<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Firebreak</name>
    <message>
        <source>1 Prepare</source>
        <translation>1 Preparar</translation>
    </message>
    <message>
        <source>2 Rank and cut</source>
        <translation>2 Ordenar y cortar</translation>
    </message>
    <message>
        <source>3 Burn</source>
        <translation>3 Quemar</translation>
    </message>
    <message>
        <source>4 Judge</source>
        <translation>4 Valorar</translation>
    </message>
    <message>
        <source>Align landscape</source>
        <translation>Alinear el paisaje</translation>
    </message>
    <message>
        <source>Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.</source>
        <translation>Lleva elevación, vegetación y densidad a una cuadrícula común en metros, con los códigos traducidos a clases de combustible.</translation>
    </message>
    <message>
        <source>The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape (.lcp) as elevation holds all layers.</source>
        <translation>Las capas pueden tener cualquier SRC, extensión y tamaño de celda; se llevan a una cuadrícula en metros. La densidad puede ser un ráster, una palabra para todo el combustible (lo cerrado que es), o faltar si la leyenda la da. Un paisaje de FlamMap (.lcp) como elevación contiene todas las capas.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevación</translation>
    </message>
    <message>
        <source>Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.</source>
        <translation>Elevación en metros, en cualquier SRC y tamaño de celda; o un archivo de paisaje (.lcp), que contiene todas las capas.</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Vegetación</translation>
    </message>
    <message>
        <source>Codes of the vegetation, explained by the legend.</source>
        <translation>Códigos de la vegetación, que explica la leyenda.</translation>
    </message>
    <message>
        <source>Vegetation density</source>
        <translation>Densidad de la vegetación</translation>
    </message>
    <message>
        <source>Codes of the density of the vegetation; without it the densities come from the legend.</source>
        <translation>Códigos de la densidad de la vegetación; sin ellos las densidades vienen de la leyenda.</translation>
    </message>
    <message>
        <source>Legend of the vegetation codes</source>
        <translation>Leyenda de los códigos de vegetación</translation>
    </message>
    <message>
        <source>What the vegetation codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Qué significan los códigos de vegetación: una leyenda incluida, o un archivo CSV propio.</translation>
    </message>
    <message>
        <source>Fuel models of Anderson 1982</source>
        <translation>Modelos de combustible de Anderson 1982</translation>
    </message>
    <message>
        <source>Canopy cover in percent as density: below 40 sparse, below 70 normal, else dense</source>
        <translation>Cobertura de copas en porcentaje como densidad: menos de 40 rala, menos de 70 normal, si no densa</translation>
    </message>
    <message>
        <source>CORINE Land Cover, level 3, three-digit codes</source>
        <translation>CORINE Land Cover, nivel 3, códigos de tres cifras</translation>
    </message>
    <message>
        <source>CORINE Land Cover as the raster of the European Environment Agency holds it: grid codes 1 to 44 in the order of level 3</source>
        <translation>CORINE Land Cover como ráster de la Agencia Europea de Medio Ambiente: códigos 1 a 44 en el orden del nivel 3</translation>
    </message>
    <message>
        <source>Vegetation densities of Russo, Russo, Siettos 2016</source>
        <translation>Densidades de vegetación de Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Fuel map of Europe in 12 classes, as the PROPAGATOR fire model uses it</source>
        <translation>Mapa de combustibles de Europa en 12 clases, como lo usa el modelo de fuego PROPAGATOR</translation>
    </message>
    <message>
        <source>Fuel types of the Canadian Forest Fire Behavior Prediction System</source>
        <translation>Tipos de combustible del Canadian Forest Fire Behavior Prediction System</translation>
    </message>
    <message>
        <source>Fuel models of Portugal</source>
        <translation>Modelos de combustible de Portugal</translation>
    </message>
    <message>
        <source>Fuel models of the Chilean Kitral system, codes as in Cell2Fire</source>
        <translation>Modelos de combustible del sistema chileno Kitral, códigos como en Cell2Fire</translation>
    </message>
    <message>
        <source>Vegetation types of Russo, Russo, Siettos 2016</source>
        <translation>Tipos de vegetación de Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Vegetation of the PROPAGATOR fire model in 7 classes</source>
        <translation>Vegetación del modelo de fuego PROPAGATOR en 7 clases</translation>
    </message>
    <message>
        <source>Fire behaviour fuel models of Scott and Burgan 2005</source>
        <translation>Modelos de combustible de Scott y Burgan 2005</translation>
    </message>
    <message>
        <source>Tree cover density in percent</source>
        <translation>Densidad de cobertura arbórea en porcentaje</translation>
    </message>
    <message>
        <source>ESA WorldCover 10 m, codes of releases 2020 v100 and 2021 v200</source>
        <translation>ESA WorldCover 10 m, códigos de las versiones 2020 v100 y 2021 v200</translation>
    </message>
    <message>
        <source>as one class for all fuel</source>
        <translation>como una sola clase para todo el combustible</translation>
    </message>
    <message>
        <source>Sparse everywhere</source>
        <translation>Rala en todas partes</translation>
    </message>
    <message>
        <source>Normal everywhere</source>
        <translation>Normal en todas partes</translation>
    </message>
    <message>
        <source>Dense everywhere</source>
        <translation>Densa en todas partes</translation>
    </message>
    <message>
        <source>As closed as the fuel around each cell is</source>
        <translation>Tan cerrada como el combustible en torno a cada celda</translation>
    </message>
    <message>
        <source>as a CSV file</source>
        <translation>como archivo CSV</translation>
    </message>
    <message>
        <source>Creation options, such as COMPRESS=ZSTD</source>
        <translation>Opciones de creación, p. ej. COMPRESS=ZSTD</translation>
    </message>
    <message>
        <source>Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.</source>
        <translation>Opción de creación del controlador COG de GDAL, p. ej. COMPRESS=ZSTD.</translation>
    </message>
    <message>
        <source>Legend of the density codes</source>
        <translation>Leyenda de los códigos de densidad</translation>
    </message>
    <message>
        <source>What the density codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Qué significan los códigos de densidad: una leyenda incluida, o un archivo CSV propio.</translation>
    </message>
    <message>
        <source>CRS of the grid</source>
        <translation>SRC de la cuadrícula</translation>
    </message>
    <message>
        <source>CRS of the grid, projected in metres [default: the "Elevation"'s if it is in metres, else the UTM zone].</source>
        <translation>SRC de la cuadrícula, proyectado en metros [si no, el de "Elevación" si está en metros, o la zona UTM].</translation>
    </message>
    <message>
        <source>Cell size [m]</source>
        <translation>Tamaño de celda [m]</translation>
    </message>
    <message>
        <source>Cell size [default: the "Elevation"'s].</source>
        <translation>Tamaño de celda [si no, el de "Elevación"].</translation>
    </message>
    <message>
        <source>Extent (needs the CRS of the grid)</source>
        <translation>Extensión (necesita el SRC de la cuadrícula)</translation>
    </message>
    <message>
        <source>Extent in the CRS of the grid [default: what all layers cover].</source>
        <translation>Extensión en el SRC de la cuadrícula [si no, lo que cubren todas las capas].</translation>
    </message>
    <message>
        <source>Take the grid of this raster</source>
        <translation>Tomar la cuadrícula de este ráster</translation>
    </message>
    <message>
        <source>Take the grid of this raster.</source>
        <translation>Toma la cuadrícula de este ráster.</translation>
    </message>
    <message>
        <source>True CRS of the layers, such as dem=EPSG:32635</source>
        <translation>SRC verdadero de las capas, p. ej. dem=EPSG:32635</translation>
    </message>
    <message>
        <source>The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.</source>
        <translation>El SRC verdadero de dem, vegetation o density, o de todos, donde un archivo no dice ninguno o uno falso.</translation>
    </message>
    <message>
        <source>No-data values, such as dem=-9999; vegetation=255</source>
        <translation>Valores sin datos, p. ej. dem=-9999; vegetation=255</translation>
    </message>
    <message>
        <source>Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says that all are data; several are separated by ;.</source>
        <translation>Valores que significan sin datos en dem, vegetation o density, p. ej. dem=-9999,32767; dem=none dice que todos son datos; varios se separan con ;.</translation>
    </message>
    <message>
        <source>Bands, such as dem=1; vegetation=2</source>
        <translation>Bandas, p. ej. dem=1; vegetation=2</translation>
    </message>
    <message>
        <source>Band to read of dem, vegetation or density.</source>
        <translation>Banda que se lee de dem, vegetation o density.</translation>
    </message>
    <message>
        <source>Codes that the legend does not list</source>
        <translation>Códigos que la leyenda no recoge</translation>
    </message>
    <message>
        <source>What to do with codes that the legend does not list.</source>
        <translation>Qué hacer con los códigos que la leyenda no recoge.</translation>
    </message>
    <message>
        <source>Refuse them</source>
        <translation>Rechazarlos</translation>
    </message>
    <message>
        <source>Take them as land without fuel</source>
        <translation>Tomarlos como suelo sin combustible</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of</source>
        <translation>Rechazar aquello de lo que solo se avisaría</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of.</source>
        <translation>Rechaza aquello de lo que solo se avisaría.</translation>
    </message>
    <message>
        <source>Allow network addresses and archives</source>
        <translation>Permitir direcciones de red y archivos comprimidos</translation>
    </message>
    <message>
        <source>Allow "Elevation", "Vegetation" and "Vegetation density" to be network addresses or in archives.</source>
        <translation>Permite que "Elevación", "Vegetación" y "Densidad de la vegetación" sean direcciones de red o estén en archivos comprimidos.</translation>
    </message>
    <message>
        <source>Most memory to use, such as 4GB</source>
        <translation>Memoria máxima, p. ej. 4GB</translation>
    </message>
    <message>
        <source>Refuse work that needs more, e.g. 4GB [default: most of what there is].</source>
        <translation>Rechaza el trabajo que necesita más, p. ej. 4GB [si no, la mayor parte de la que hay].</translation>
    </message>
    <message>
        <source>Calibration, or the account (run.json) of an earlier run</source>
        <translation>Calibración, o registro (run.json) de una ejecución anterior</translation>
    </message>
    <message>
        <source>Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.</source>
        <translation>Toma parámetros de un archivo TOML, o del run.json de una ejecución anterior; lo que se da aquí prevalece.</translation>
    </message>
    <message>
        <source>Elevation on the common grid</source>
        <translation>Elevación en la cuadrícula común</translation>
    </message>
    <message>
        <source>Vegetation classes on the common grid</source>
        <translation>Clases de vegetación en la cuadrícula común</translation>
    </message>
    <message>
        <source>Density classes on the common grid</source>
        <translation>Clases de densidad en la cuadrícula común</translation>
    </message>
    <message>
        <source>Effect of the vegetation, where the legend gives numbers in place of classes</source>
        <translation>Efecto de la vegetación, donde la leyenda da números en lugar de clases</translation>
    </message>
    <message>
        <source>Effect of the density, where the legend gives numbers in place of classes</source>
        <translation>Efecto de la densidad, donde la leyenda da números en lugar de clases</translation>
    </message>
    <message>
        <source>Rate of spread on flat calm dry ground, where the legend gives it</source>
        <translation>Velocidad de propagación en terreno llano y seco sin viento, donde la leyenda la da</translation>
    </message>
    <message>
        <source>Load of dead fuel, where the legend gives it</source>
        <translation>Carga de combustible muerto, donde la leyenda la da</translation>
    </message>
    <message>
        <source>Load of live fuel, where the legend gives it</source>
        <translation>Carga de combustible vivo, donde la leyenda la da</translation>
    </message>
    <message>
        <source>Heat content of the fuel, where the legend gives it</source>
        <translation>Poder calorífico del combustible, donde la leyenda lo da</translation>
    </message>
    <message>
        <source>Moisture of the live fuel, where the legend gives it</source>
        <translation>Humedad del combustible vivo, donde la leyenda la da</translation>
    </message>
    <message>
        <source>Account of the run</source>
        <translation>Registro de la ejecución</translation>
    </message>
    <message>
        <source>Folder for all files</source>
        <translation>Carpeta para todos los archivos</translation>
    </message>
    <message>
        <source>Spread network</source>
        <translation>Red de propagación</translation>
    </message>
    <message>
        <source>Find how likely fire spreads from each cell to its neighbours.</source>
        <translation>Halla con qué probabilidad pasa el fuego de cada celda a sus vecinas.</translation>
    </message>
    <message>
        <source>Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). Wind and slope then act on the times; so make a network without times for fires without a duration.</source>
        <translation>Las bandas 1 a 8 contienen la probabilidad de que el fuego pase al N, NE, E, SE, S, SO, O y NO. Si se dan también los tiempos, las bandas 9 a 16 contienen los segundos que tarda, y la banda 17 el calor que libera la celda (kJ/m2). El viento y la pendiente actúan entonces sobre los tiempos; para incendios sin duración haga, pues, una red sin tiempos.</translation>
    </message>
    <message>
        <source>Cells with fuel</source>
        <translation>Celdas con combustible</translation>
    </message>
    <message>
        <source>Spread model</source>
        <translation>Modelo de propagación</translation>
    </message>
    <message>
        <source>How fire gets from a cell to its neighbours; all are described below.</source>
        <translation>Cómo llega el fuego de una celda a sus vecinas; todos se describen abajo.</translation>
    </message>
    <message>
        <source>Alexandridis: cellular automaton of vegetation type, density, slope and wind</source>
        <translation>Alexandridis: autómata celular de tipo de vegetación, densidad, pendiente y viento</translation>
    </message>
    <message>
        <source>Artificial forest: the probability of catching fire is the fuel of the target cell</source>
        <translation>Bosque artificial: la probabilidad de prender es el combustible de la celda de destino</translation>
    </message>
    <message>
        <source>Raster: your own probabilities, and perhaps travel times, from another fire model</source>
        <translation>Ráster: probabilidades propias, y si las hay tiempos, de otro modelo de fuego</translation>
    </message>
    <message>
        <source>Wind speed [m/s]</source>
        <translation>Velocidad del viento [m/s]</translation>
    </message>
    <message>
        <source>Wind speed at mid-flame height in m/s, or a raster of it on any grid.</source>
        <translation>Velocidad del viento a media altura de llama en m/s, o un ráster de ella en cualquier cuadrícula.</translation>
    </message>
    <message>
        <source>Wind from [degrees clockwise from north]</source>
        <translation>Viento desde [grados en sentido horario desde el norte]</translation>
    </message>
    <message>
        <source>Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.</source>
        <translation>Dirección de la que viene el viento, en sentido horario desde el norte: 270 es viento del oeste; un número o un ráster.</translation>
    </message>
    <message>
        <source>Tell times too (for fires with a duration)</source>
        <translation>Dar también los tiempos (para incendios con duración)</translation>
    </message>
    <message>
        <source>Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.</source>
        <translation>Da también cuánto tarda el fuego de celda a celda (bandas 9 a 16, segundos) y el calor de cada celda.</translation>
    </message>
    <message>
        <source>as a raster</source>
        <translation>como ráster</translation>
    </message>
    <message>
        <source>Wind towards east and north, in place of speed and direction [m/s]</source>
        <translation>Viento hacia el este y el norte, en lugar de velocidad y dirección [m/s]</translation>
    </message>
    <message>
        <source>Components of the wind towards east and north, in place of the two above: rasters on any grid.</source>
        <translation>Componentes del viento hacia el este y el norte, en lugar de los dos de arriba: rásteres en cualquier cuadrícula.</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel (8 % is 0.08)</source>
        <translation>Humedad del combustible muerto fino (8 % es 0.08)</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.</source>
        <translation>Humedad del combustible muerto fino como proporción de su peso seco (8 % es 0.08 u 8%), o un ráster de ella.</translation>
    </message>
    <message>
        <source>Neighbours that a cell can light</source>
        <translation>Vecinas que una celda puede encender</translation>
    </message>
    <message>
        <source>Cells to which fire can spread from a cell.</source>
        <translation>Celdas a las que puede pasar el fuego desde una celda.</translation>
    </message>
    <message>
        <source>All eight</source>
        <translation>Las ocho</translation>
    </message>
    <message>
        <source>The four that share a side</source>
        <translation>Las cuatro que comparten un lado</translation>
    </message>
    <message>
        <source>Parameters of the spread model, such as p0=0.5</source>
        <translation>Parámetros del modelo de propagación, p. ej. p0=0.5</translation>
    </message>
    <message>
        <source>Parameter of the spread model, e.g. p0=0.5; several are separated by ;.</source>
        <translation>Parámetro del modelo de propagación, p. ej. p0=0.5; varios se separan con ;.</translation>
    </message>
    <message>
        <source>File with the probabilities for other tools (.mtx, .npz)</source>
        <translation>Archivo con las probabilidades para otros programas (.mtx, .npz)</translation>
    </message>
    <message>
        <source>Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or .graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.</source>
        <translation>Escribe además las probabilidades para otros programas: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) o .graphml (hasta 20,000 celdas con combustible). Las celdas se numeran fila a fila desde arriba a la izquierda.</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; with 8 by 0.002 and 3.4 %. Every command reads such files.</source>
        <translation>Bits de cada número en el archivo. Con 16 las probabilidades yerran en 8e-6 como máximo, los tiempos y el calor en 0.013 %; con 8, en 0.002 y 3.4 %. Todas las órdenes leen estos archivos.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exacto</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>Where a line can be held</source>
        <translation>Dónde se puede defender una línea</translation>
    </message>
    <message>
        <source>Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by it.</source>
        <translation>Valora de 0 a 1 lo bien que se puede defender una línea en cada celda: lo que vale la mejor línea al alcance (crestas, fondos de valle, carreteras, ríos, bordes del combustible), con la pendiente para las máquinas y el acceso. Los planes lo siguen.</translation>
    </message>
    <message>
        <source>The weights have no source for your region: they are yours to set.</source>
        <translation>Los pesos no tienen fuente para su región: los fija usted.</translation>
    </message>
    <message>
        <source>Mean suitability where there is fuel</source>
        <translation>Aptitud media donde hay combustible</translation>
    </message>
    <message>
        <source>Roads and tracks</source>
        <translation>Carreteras y pistas</translation>
    </message>
    <message>
        <source>Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which crews drive; those that stop fire are barriers too.</source>
        <translation>Carreteras y pistas (líneas o un ráster), junto a las que los cortafuegos son más fáciles de construir y defender, y por las que van los equipos; las que detienen el fuego son también barreras.</translation>
    </message>
    <message>
        <source>Rivers and lakes</source>
        <translation>Ríos y lagos</translation>
    </message>
    <message>
        <source>Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are barriers too.</source>
        <translation>Ríos y lagos (líneas, áreas, un ráster), junto a los que los cortafuegos son más fáciles de defender; los que detienen el fuego son también barreras.</translation>
    </message>
    <message>
        <source>What lines of the ground are worth, such as ridge=0.8; reach=60</source>
        <translation>Lo que valen las líneas del terreno, p. ej. ridge=0.8; reach=60</translation>
    </message>
    <message>
        <source>What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; several are separated by ;.</source>
        <translation>Lo que vale una línea, o un alcance, p. ej. ridge=0.8, valley=0 o reach=60; varios se separan con ;.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines</source>
        <translation>Compartimentos delimitados por líneas de control</translation>
    </message>
    <message>
        <source>Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: potential operational delineations (PODs), on which crews agree before a fire.</source>
        <translation>Dividir el paisaje en compartimentos de tamaño parecido, delimitados por las líneas más fáciles de defender: delimitaciones operativas potenciales (PODs), que los equipos acuerdan antes de un incendio.</translation>
    </message>
    <message>
        <source>Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. The second layer of the file holds the borders.</source>
        <translation>Cada compartimento tiene su combustible, sus igniciones y valores, lo que arde en incendios simulados y la calidad de su límite. La segunda capa del archivo contiene los límites.</translation>
    </message>
    <message>
        <source>Compartments</source>
        <translation>Compartimentos</translation>
    </message>
    <message>
        <source>Borders in kilometres</source>
        <translation>Límites en kilómetros</translation>
    </message>
    <message>
        <source>Mean suitability of the borders</source>
        <translation>Aptitud media de los límites</translation>
    </message>
    <message>
        <source>Size of the compartments, such as 500ha</source>
        <translation>Tamaño de los compartimentos, p. ej. 500ha</translation>
    </message>
    <message>
        <source>Size of the compartments, hectares of fuel; none is larger than one and a half times this.</source>
        <translation>Tamaño de los compartimentos, en hectáreas de combustible; ninguno supera una vez y media este valor.</translation>
    </message>
    <message>
        <source>Values at risk</source>
        <translation>Valores en riesgo</translation>
    </message>
    <message>
        <source>Values at risk: a raster, or polygons or points with "Field with the value" [default: 1 on fuel].</source>
        <translation>Valores en riesgo: un ráster, o polígonos o puntos con "Campo con el valor" [si no, 1 sobre combustible].</translation>
    </message>
    <message>
        <source>How long fires burn, such as 8h</source>
        <translation>Cuánto duran los incendios, p. ej. 8h</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: lognormal:8h,0.7, an assumption].</source>
        <translation>Cuánto duran los incendios: 8h, una lista que las ejecuciones toman por turno (4h,8h), lognormal:8h,0.7 (mediana y sigma), uniform:2h,12h, o weather [si no, lognormal:8h,0.7, un supuesto].</translation>
    </message>
    <message>
        <source>Ignition points</source>
        <translation>Puntos de ignición</translation>
    </message>
    <message>
        <source>Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of ignition probability [default: one random cell with fuel a run].</source>
        <translation>Puntos, polígonos (perímetros que ya arden; cualquier archivo vectorial, o CSV con x e y) o un ráster de probabilidad de ignición [si no, una celda al azar con combustible por ejecución].</translation>
    </message>
    <message>
        <source>Number of fires</source>
        <translation>Número de incendios</translation>
    </message>
    <message>
        <source>Simulated fires.</source>
        <translation>Incendios simulados.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Seed of all draws.</source>
        <translation>Semilla de todos los sorteos.</translation>
    </message>
    <message>
        <source>How much more the worst ground counts than the best</source>
        <translation>Cuánto más cuenta el peor terreno que el mejor</translation>
    </message>
    <message>
        <source>Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.</source>
        <translation>Número de veces que el peor terreno cuenta lo que el mejor, de 1 a 100; con 1 se piden los límites más cortos.</translation>
    </message>
    <message>
        <source>Field with the value</source>
        <translation>Campo con el valor</translation>
    </message>
    <message>
        <source>Column of the value polygons or points [default: 1 for each].</source>
        <translation>Columna de los polígonos o puntos de valor [si no, 1 para cada uno].</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Los valores son</translation>
    </message>
    <message>
        <source>What the numbers of "Values at risk" are: so much in each cell of the raster, polygon or point (people), the sum of which is kept; or so much a hectare.</source>
        <translation>Qué son los números de "Valores en riesgo": tanto en cada celda del ráster, polígono o punto (personas), cuya suma se conserva; o tanto por hectárea.</translation>
    </message>
    <message>
        <source>So much in each cell, polygon or point</source>
        <translation>Tanto en cada celda, polígono o punto</translation>
    </message>
    <message>
        <source>So much a hectare</source>
        <translation>Tanto por hectárea</translation>
    </message>
    <message>
        <source>Several values at risk, such as people=villages.gpkg,weight=2</source>
        <translation>Varios valores en riesgo, p. ej. people=villages.gpkg,weight=2</translation>
    </message>
    <message>
        <source>Several values at risk, each as a name and a file, with its field, a weight (what a unit counts in the sum that is planned for) and as=density after it as needed; several are separated by ;, each is told by name.</source>
        <translation>Varios valores en riesgo, cada uno como nombre y archivo, seguido si hace falta de su campo, un peso (lo que cuenta una unidad en la suma para la que se planifica) y as=density; varios se separan con ;, cada uno se da por su nombre.</translation>
    </message>
    <message>
        <source>Conditions on features, such as barriers=highway = 'primary'</source>
        <translation>Condiciones sobre objetos, p. ej. barriers=highway = 'primary'</translation>
    </message>
    <message>
        <source>Take only features that fit a condition, with the name of the layer before it, such as barriers=highway = 'primary'; several are separated by ;.</source>
        <translation>Toma solo los objetos que cumplen una condición, con el nombre de la capa delante, p. ej. barriers=highway = 'primary'; varias se separan con ;.</translation>
    </message>
    <message>
        <source>Use of the ignition points</source>
        <translation>Uso de los puntos de ignición</translation>
    </message>
    <message>
        <source>With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or start where such fires of the past are dense.</source>
        <translation>Con puntos o polígonos: las ejecuciones los toman por turno (la semilla sortea el orden), empiezan en todos, o empiezan donde tales incendios del pasado son densos.</translation>
    </message>
    <message>
        <source>One for each fire, in turn</source>
        <translation>Uno por incendio, por turno</translation>
    </message>
    <message>
        <source>All at once in every fire</source>
        <translation>Todos a la vez en cada incendio</translation>
    </message>
    <message>
        <source>More fires where they are dense</source>
        <translation>Más incendios donde son densos</translation>
    </message>
    <message>
        <source>Ignition points without fuel</source>
        <translation>Puntos de ignición sin combustible</translation>
    </message>
    <message>
        <source>What to do with points and polygons off the landscape or without fuel.</source>
        <translation>Qué hacer con puntos y polígonos fuera del paisaje o sin combustible.</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Dejarlos fuera</translation>
    </message>
    <message>
        <source>Column with the hour of each ignition</source>
        <translation>Columna con la hora de cada ignición</translation>
    </message>
    <message>
        <source>Column of the ignitions that tells when each is lit, in hours after the start of the run.</source>
        <translation>Columna de las igniciones que dice cuándo se enciende cada una, en horas desde el comienzo de la ejecución.</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Pavesas</translation>
    </message>
    <message>
        <source>Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.</source>
        <translation>Pavesas que vuelan por delante del fuego: on, o números como rate=12,longest=1000 en lugar de los supuestos.</translation>
    </message>
    <message>
        <source>When crews contain a fire, such as 6h</source>
        <translation>Cuándo los medios contienen un incendio, p. ej. 6h</translation>
    </message>
    <message>
        <source>When crews contain each fire: a time or a distribution as for "How long fires burn", or a direct attack at such a time, which fails if the fire is too large or too fierce by then: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].</source>
        <translation>Cuándo los medios contienen cada incendio: un tiempo o una distribución como en "Cuánto duran los incendios", o un ataque directo en tal momento, que fracasa si el fuego es ya demasiado grande o intenso: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha por encima) [si no, nunca].</translation>
    </message>
    <message>
        <source>How often a break holds, such as 0.47</source>
        <translation>Con qué frecuencia aguanta un cortafuegos, p. ej. 0.47</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: 0.47, an assumption].</source>
        <translation>Con qué frecuencia aguanta un trozo de cortafuegos en una ejecución: una proporción (0.47 en el campo), flame (por anchura e intensidad del fuego, Wilson 1988) o flame:flames (1.5 longitudes de llama); los trozos tienen 400 m, o como en 0.47:800 [si no, 0.47, un supuesto].</translation>
    </message>
    <message>
        <source>How often a barrier holds, such as 0.9</source>
        <translation>Con qué frecuencia aguanta una barrera, p. ej. 0.9</translation>
    </message>
    <message>
        <source>Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.</source>
        <translation>Proporción de ejecuciones en que aguanta un trozo de las barreras; se sortea aparte de los cortafuegos.</translation>
    </message>
    <message>
        <source>Stations of crews whom breaks wait for</source>
        <translation>Bases de los medios a los que esperan los cortafuegos</translation>
    </message>
    <message>
        <source>Points or areas that crews set out from: a stretch of break holds only against fire that comes after them [default: crews are everywhere].</source>
        <translation>Puntos o áreas de donde salen los medios: un trozo de cortafuegos solo aguanta ante el fuego que llega después de ellos [si no, hay medios en todas partes].</translation>
    </message>
    <message>
        <source>Travel of crews, such as road=40,off=3,delay=10</source>
        <translation>Desplazamiento de los medios, p. ej. road=40,off=3,delay=10</translation>
    </message>
    <message>
        <source>How they travel: speed on roads and off them in km/h, and minutes from the start of the fire until they leave [default: road=40,off=3,delay=10, assumptions].</source>
        <translation>Cómo se desplazan: velocidad por carretera y fuera de ella en km/h, y minutos desde el comienzo del incendio hasta que salen [si no, road=40,off=3,delay=10, supuestos].</translation>
    </message>
    <message>
        <source>Fires without an end by time</source>
        <translation>Incendios sin final por tiempo</translation>
    </message>
    <message>
        <source>Fires end by themselves and breaks hold in every fire unless "How often a break holds" says otherwise, as in the paper.</source>
        <translation>Los incendios acaban por sí mismos y los cortafuegos aguantan en todos, si "Con qué frecuencia aguanta un cortafuegos" no dice otra cosa, como en el artículo.</translation>
    </message>
    <message>
        <source>Table of weather</source>
        <translation>Tabla meteorológica</translation>
    </message>
    <message>
        <source>Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2.</source>
        <translation>Conjunto de situaciones meteorológicas, de las que cada ejecución saca una: un archivo CSV con wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; o una rosa de los vientos como rose:NW=5x0.4,N=8x0.2.</translation>
    </message>
    <message>
        <source>as a wind rose: rose:NW=5x0.4,N=8x0.2</source>
        <translation>como rosa de los vientos: rose:NW=5x0.4,N=8x0.2</translation>
    </message>
    <message>
        <source>Time of each line of the table of weather, such as 1h</source>
        <translation>Duración de cada línea de la tabla meteorológica, p. ej. 1h</translation>
    </message>
    <message>
        <source>The lines of the weather follow each other, and each lasts so long, e.g. 1h.</source>
        <translation>Las líneas de la meteorología se suceden, y cada una dura esto, p. ej. 1h.</translation>
    </message>
    <message>
        <source>Columns of the table of weather, such as wind_speed=FF</source>
        <translation>Columnas de la tabla meteorológica, p. ej. wind_speed=FF</translation>
    </message>
    <message>
        <source>Name of a column of the weather, e.g. wind_speed=FF; several are separated by ;.</source>
        <translation>Nombre de una columna de la meteorología, p. ej. wind_speed=FF; varios se separan con ;.</translation>
    </message>
    <message>
        <source>Units of the table of weather, such as wind_speed=kn</source>
        <translation>Unidades de la tabla meteorológica, p. ej. wind_speed=kn</translation>
    </message>
    <message>
        <source>Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; several are separated by ;.</source>
        <translation>Unidad de una columna de la meteorología que no la dice, p. ej. wind_speed=kn; varias se separan con ;.</translation>
    </message>
    <message>
        <source>Columns of the table of weather to leave out</source>
        <translation>Columnas de la tabla meteorológica que se dejan fuera</translation>
    </message>
    <message>
        <source>Columns of the weather to leave out, separated by commas.</source>
        <translation>Columnas de la meteorología que se dejan fuera, separadas por comas.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, and their borders</source>
        <translation>Compartimentos delimitados por líneas de control, y sus límites</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, without outlines</source>
        <translation>Compartimentos delimitados por líneas de control, sin contornos</translation>
    </message>
    <message>
        <source>Borders of the compartments, without lines</source>
        <translation>Límites de los compartimentos, sin líneas</translation>
    </message>
    <message>
        <source>Plan fire breaks</source>
        <translation>Planificar cortafuegos</translation>
    </message>
    <message>
        <source>Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and with the breaks.</source>
        <translation>Planifica cortafuegos a partir de capas: dónde cortar, qué construir primero y con qué frecuencia arde cada celda sin y con los cortafuegos.</translation>
    </message>
    <message>
        <source>Cells cut</source>
        <translation>Celdas cortadas</translation>
    </message>
    <message>
        <source>Area cut in hectares</source>
        <translation>Superficie cortada en hectáreas</translation>
    </message>
    <message>
        <source>Mean burnt share without breaks</source>
        <translation>Proporción quemada media sin cortafuegos</translation>
    </message>
    <message>
        <source>Mean burnt share with the breaks</source>
        <translation>Proporción quemada media con los cortafuegos</translation>
    </message>
    <message>
        <source>Area where nothing may be cut</source>
        <translation>Zona donde no se puede cortar</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.</source>
        <translation>Zona (ráster o polígonos; las líneas toman las celdas que tocan) donde no se puede cortar.</translation>
    </message>
    <message>
        <source>Existing barriers</source>
        <translation>Barreras existentes</translation>
    </message>
    <message>
        <source>Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and cost nothing.</source>
        <translation>Cortafuegos, carreteras y ríos existentes (ráster, líneas o polígonos): las celdas que atraviesan no tienen combustible y no cuestan nada.</translation>
    </message>
    <message>
        <source>Budget, such as 10%, 5ha or 20000eur</source>
        <translation>Presupuesto, p. ej. 10%, 5ha o 20000eur</translation>
    </message>
    <message>
        <source>How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or money such as 20000eur, in the currency of the costs.</source>
        <translation>Cuánto cortar: una proporción de las celdas con combustible como 10% o 0.1, una superficie como 5ha, o dinero como 20000eur, en la moneda de los costes.</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Método de ordenación</translation>
    </message>
    <message>
        <source>By which cells are ranked; higher is cut earlier. All are described below.</source>
        <translation>Según qué se ordenan las celdas; más alto se corta antes. Todos se describen abajo.</translation>
    </message>
    <message>
        <source>Betweenness centrality: cells that lie on many fastest routes of fire</source>
        <translation>Centralidad de intermediación: celdas que están en muchas rutas más rápidas del fuego</translation>
    </message>
    <message>
        <source>Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves</source>
        <translation>Centralidad de Bonacich: celdas por las que el fuego llega a celdas que a su vez se alcanzan fácilmente</translation>
    </message>
    <message>
        <source>Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere</source>
        <translation>Centralidad de cercanía: celdas a las que el fuego llega pronto desde cualquier lugar, o desde las que llega pronto a cualquiera</translation>
    </message>
    <message>
        <source>Compartments: a square grid of bands that encloses equal ones</source>
        <translation>Compartimentos: una malla cuadrada de fajas que encierra compartimentos iguales</translation>
    </message>
    <message>
        <source>Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone</source>
        <translation>Intermediación por flujo de corriente: celdas por las que pasa la propagación por cualquier ruta, no solo por la más rápida</translation>
    </message>
    <message>
        <source>Degree: cells that are lit by, or light, their neighbours most</source>
        <translation>Grado: celdas que más encienden a sus vecinas o más son encendidas por ellas</translation>
    </message>
    <message>
        <source>Defensible fuel profile zones (DFPZ): broad bands along roads and ridges</source>
        <translation>Zonas de combustible defendibles (DFPZ): fajas anchas a lo largo de caminos y crestas</translation>
    </message>
    <message>
        <source>Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first</source>
        <translation>Disección: muros entre compartimentos por cortes mínimos anidados, primero los que más ahorran por su coste</translation>
    </message>
    <message>
        <source>Dominator: exact gain of cutting one cell, found anew after every few cuts</source>
        <translation>Dominador: ganancia exacta de cortar una celda, hallada de nuevo cada pocos cortes</translation>
    </message>
    <message>
        <source>DomiRank: cells that dominate their neighbourhood when neighbours compete</source>
        <translation>DomiRank: celdas que dominan su entorno cuando las vecinas compiten</translation>
    </message>
    <message>
        <source>Downstream protection value: cells from which most value was lit, found anew after every few cuts</source>
        <translation>Valor de protección aguas abajo: celdas desde las que se encendió más valor, halladas de nuevo cada pocos cortes</translation>
    </message>
    <message>
        <source>Eigenvector centrality: cells next to the cells that matter most, all in one place of the map</source>
        <translation>Centralidad de vector propio: celdas junto a las celdas que más importan, todas en un mismo lugar del mapa</translation>
    </message>
    <message>
        <source>Flammability: most flammable cells first, the conventional policy, which looks at each cell alone</source>
        <translation>Inflamabilidad: primero las celdas más inflamables, la práctica habitual, que mira cada celda por separado</translation>
    </message>
    <message>
        <source>Group betweenness: built cell by cell, each covers fastest routes that the group leaves open</source>
        <translation>Intermediación de grupo: formado celda a celda, cada una cubre rutas más rápidas que el grupo deja abiertas</translation>
    </message>
    <message>
        <source>Influence: cells by way of which fires with a clock take most, found anew after every few cuts on the same draws</source>
        <translation>Influencia: celdas a través de las cuales los incendios con reloj queman más, halladas de nuevo tras cada pocos cortes con los mismos sorteos</translation>
    </message>
    <message>
        <source>Information centrality: cells that many parallel ways of spread join closely to all others</source>
        <translation>Centralidad de información: celdas que muchas vías paralelas de propagación unen estrechamente con todas las demás</translation>
    </message>
    <message>
        <source>PageRank: cells that a fire wandering at random from cell to cell is often in</source>
        <translation>PageRank: celdas en las que está a menudo un fuego que vaga al azar de celda en celda</translation>
    </message>
    <message>
        <source>Percolation centrality: cells on many fastest routes from where fires start</source>
        <translation>Centralidad de percolación: celdas en muchas rutas más rápidas desde donde empiezan los incendios</translation>
    </message>
    <message>
        <source>Random: cells in random order, the baseline that every plan must beat</source>
        <translation>Azar: celdas en orden aleatorio, la referencia que todo plan debe superar</translation>
    </message>
    <message>
        <source>Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them</source>
        <translation>Áreas de tratamiento situadas estratégicamente (SPLAT): parches al tresbolillo que frenan el fuego, sin paso recto entre ellos</translation>
    </message>
    <message>
        <source>Stripes: parallel bands across a direction, the plainest pattern of practice</source>
        <translation>Franjas: fajas paralelas a través de una dirección, el patrón más sencillo de la práctica</translation>
    </message>
    <message>
        <source>Unit of a budget that is a plain number</source>
        <translation>Unidad de un presupuesto que es un número solo</translation>
    </message>
    <message>
        <source>What a plain number for "Budget" counts: a share of the fuel, hectares, or money [default: share].</source>
        <translation>Qué cuenta un número solo en "Presupuesto": una proporción del combustible, hectáreas, o dinero [si no, proporción].</translation>
    </message>
    <message>
        <source>Share of the fuel (0 to 1)</source>
        <translation>Proporción del combustible (0 a 1)</translation>
    </message>
    <message>
        <source>Hectares</source>
        <translation>Hectáreas</translation>
    </message>
    <message>
        <source>Money</source>
        <translation>Dinero</translation>
    </message>
    <message>
        <source>Parameters of the ranking, such as beta=0.5; width=60</source>
        <translation>Parámetros del método de ordenación, p. ej. beta=0.5; width=60</translation>
    </message>
    <message>
        <source>Parameter of the ranking, e.g. beta=0.5; several are separated by ;.</source>
        <translation>Parámetro del método de ordenación, p. ej. beta=0.5; varios se separan con ;.</translation>
    </message>
    <message>
        <source>Share of the spread that a break lets through</source>
        <translation>Proporción de la propagación que deja pasar un cortafuegos</translation>
    </message>
    <message>
        <source>Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.</source>
        <translation>Proporción de su probabilidad de propagación que conserva una celda tratada; 0 es un cortafuegos perfecto, los reales dejan pasar algo.</translation>
    </message>
    <message>
        <source>Least width of the breaks [m]</source>
        <translation>Anchura mínima de los cortafuegos [m]</translation>
    </message>
    <message>
        <source>Least width of the breaks, rounded up to whole cells [default: one cell, or the best for "Share of the spread that a break lets through"].</source>
        <translation>Anchura mínima de los cortafuegos, redondeada a celdas enteras [si no, una celda, o la mejor para "Proporción de la propagación que deja pasar un cortafuegos"].</translation>
    </message>
    <message>
        <source>Improve the breaks on simulated fires (takes longer)</source>
        <translation>Mejorar los cortafuegos con incendios simulados (tarda más)</translation>
    </message>
    <message>
        <source>Improve the breaks by local search on simulated fires; takes longer.</source>
        <translation>Mejora los cortafuegos por búsqueda local con incendios simulados; tarda más.</translation>
    </message>
    <message>
        <source>Fires that the plan is made for</source>
        <translation>Incendios para los que se hace el plan</translation>
    </message>
    <message>
        <source>What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).</source>
        <translation>Qué debe ser pequeño: la pérdida del incendio medio, o la de la peor décima parte de los incendios (CVaR).</translation>
    </message>
    <message>
        <source>The mean fire</source>
        <translation>El incendio medio</translation>
    </message>
    <message>
        <source>The worst tenth of the fires</source>
        <translation>La peor décima parte de los incendios</translation>
    </message>
    <message>
        <source>Width of breaks that are lines [m]</source>
        <translation>Anchura de los cortafuegos que son líneas [m]</translation>
    </message>
    <message>
        <source>Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length times their width. With "How often a break holds" flame, auto is the width with which fires take least. cells cuts whole cells, as in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.</source>
        <translation>Anchura de las líneas que forman los cortafuegos, p. ej. 12m, también menor que una celda; el presupuesto cuenta su longitud por su anchura. Con "Con qué frecuencia aguanta un cortafuegos" flame, auto es la anchura con la que los incendios queman menos. cells corta celdas enteras, como en el artículo. Por defecto: líneas de la anchura de una celda, como mucho 30 m, donde los incendios tienen reloj y los cortafuegos no dejan pasar el fuego.</translation>
    </message>
    <message>
        <source>Treatments (CSV, or default)</source>
        <translation>Tratamientos (CSV, o default)</translation>
    </message>
    <message>
        <source>Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires burn with what they leave [default: all segments alike, by "Share of the spread that a break lets through"].</source>
        <translation>Tabla de tratamientos (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), o default: cada tramo recibe el que más ahorra por su coste, un presupuesto en dinero es lo que cuestan, y los incendios arden con lo que dejan [si no, todos los tramos iguales, según "Proporción de la propagación que deja pasar un cortafuegos"].</translation>
    </message>
    <message>
        <source>as a word</source>
        <translation>como palabra</translation>
    </message>
    <message>
        <source>Breaks that stand already</source>
        <translation>Cortafuegos que ya existen</translation>
    </message>
    <message>
        <source>Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.</source>
        <translation>Cortafuegos que ya existen (líneas, polígonos o un ráster del que cada parte conexa es uno): los incendios los encuentran con y sin el plan, fallan como los nuevos y su combustible vuelve a crecer si no se mantienen.</translation>
    </message>
    <message>
        <source>as polygons or lines</source>
        <translation>como polígonos o líneas</translation>
    </message>
    <message>
        <source>Years of building and upkeep</source>
        <translation>Años de construcción y mantenimiento</translation>
    </message>
    <message>
        <source>Number of years over which the breaks are built and kept up; 1: all is built at once.</source>
        <translation>Número de años en que se construyen y mantienen los cortafuegos; 1: todo se construye de una vez.</translation>
    </message>
    <message>
        <source>Budget of each year, such as 500ha</source>
        <translation>Presupuesto de cada año, p. ej. 500ha</translation>
    </message>
    <message>
        <source>What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share [default: what all breaks cost, over the years].</source>
        <translation>Lo que cada año permite para mantenimiento, que se paga primero, y construcción: 500ha, 20000eur o una proporción [si no, lo que cuestan todos los cortafuegos, entre los años].</translation>
    </message>
    <message>
        <source>Fires that start in a year</source>
        <translation>Incendios que empiezan en un año</translation>
    </message>
    <message>
        <source>Number of fires that start in a year.</source>
        <translation>Número de incendios que empiezan en un año.</translation>
    </message>
    <message>
        <source>Discount rate a year, such as 3%</source>
        <translation>Tasa de descuento anual, p. ej. 3%</translation>
    </message>
    <message>
        <source>Rate a year, such as 3%, at which later costs and losses count less.</source>
        <translation>Tasa anual, p. ej. 3%, con la que los costes y pérdidas posteriores cuentan menos.</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back</source>
        <translation>Años hasta que el combustible tratado vuelve a crecer</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "Treatments", or agricultural=3,shrubs=4,pines=4, an assumption].</source>
        <translation>Años hasta que el combustible tratado vuelve a crecer: 4, o agricultural=3,shrubs=4,pines=8 [si no, los de "Tratamientos", o agricultural=3,shrubs=4,pines=4, un supuesto].</translation>
    </message>
    <message>
        <source>Cost of treating anew, as a share of treating first</source>
        <translation>Coste de volver a tratar, como proporción del primer tratamiento</translation>
    </message>
    <message>
        <source>What treating anew costs, as a share of treating first.</source>
        <translation>Lo que cuesta volver a tratar, como proporción del primer tratamiento.</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare</source>
        <translation>Coste de corta por hectárea</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost", or classes such as agricultural=500,shrubs=900,pines=1500.</source>
        <translation>Coste de corta por hectárea: un ráster, polígonos con "Campo con el coste", o clases como agricultural=500,shrubs=900,pines=1500.</translation>
    </message>
    <message>
        <source>as classes: agricultural=500,pines=1500</source>
        <translation>como clases: agricultural=500,pines=1500</translation>
    </message>
    <message>
        <source>Field with the cost</source>
        <translation>Campo con el coste</translation>
    </message>
    <message>
        <source>Column of the cost polygons.</source>
        <translation>Columna de los polígonos de coste.</translation>
    </message>
    <message>
        <source>Cost per hectare where none is known</source>
        <translation>Coste por hectárea donde no se conoce ninguno</translation>
    </message>
    <message>
        <source>Cost per hectare where "Cost of cutting per hectare" tells none; alone, everywhere [default: nothing is cut there].</source>
        <translation>Coste por hectárea donde "Coste de corta por hectárea" no dice ninguno; si va solo, en todas partes [si no, allí no se corta].</translation>
    </message>
    <message>
        <source>Area outside of which nothing may be cut</source>
        <translation>Zona fuera de la cual no se puede cortar</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.</source>
        <translation>Zona (ráster o polígonos; las líneas toman las celdas que tocan) fuera de la cual no se puede cortar.</translation>
    </message>
    <message>
        <source>Cells that protected and allowed areas keep</source>
        <translation>Celdas que las zonas protegidas y permitidas conservan</translation>
    </message>
    <message>
        <source>Cells that "Area where nothing may be cut" and "Area outside of which nothing may be cut" keep from being cut: all with a part inside the one or outside the other, or those whose centre is.</source>
        <translation>Celdas que "Zona donde no se puede cortar" y "Zona fuera de la cual no se puede cortar" libran de la corta: todas las que tienen una parte dentro de la una o fuera de la otra, o aquellas cuyo centro lo está.</translation>
    </message>
    <message>
        <source>Cells with any part in the area</source>
        <translation>Celdas con alguna parte en la zona</translation>
    </message>
    <message>
        <source>Cells whose centre is in the area</source>
        <translation>Celdas cuyo centro está en la zona</translation>
    </message>
    <message>
        <source>Area of interest that is planned for</source>
        <translation>Área de interés para la que se planifica</translation>
    </message>
    <message>
        <source>Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start and burn there too.</source>
        <translation>Área de interés (ráster o polígonos) para la que se planifica: fuera no se corta nada, pero los fuegos empiezan y arden también allí.</translation>
    </message>
    <message>
        <source>How much more a break counts in bad ground (0: all ground alike)</source>
        <translation>Cuánto más cuenta un cortafuegos en mal terreno (0: todo igual)</translation>
    </message>
    <message>
        <source>How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].</source>
        <translation>Cuánto más cuenta un cortafuegos en el peor terreno que en una cresta, una carretera, un río o el borde del combustible; 0: todo el terreno igual, como en el artículo [por defecto: 1.5 donde el terreno se conoce y tiene relieve].</translation>
    </message>
    <message>
        <source>Steeper ground is not cut [degrees]</source>
        <translation>El terreno más empinado no se corta [grados]</translation>
    </message>
    <message>
        <source>Ground that is steeper is not cut.</source>
        <translation>El terreno que es más empinado no se corta.</translation>
    </message>
    <message>
        <source>Cut only within this distance of roads, such as 200m</source>
        <translation>Cortar solo a esta distancia de carreteras, p. ej. 200m</translation>
    </message>
    <message>
        <source>Only ground within this of a road is cut: 200m.</source>
        <translation>Solo se corta el terreno a esta distancia de una carretera: 200m.</translation>
    </message>
    <message>
        <source>Cut nothing within this distance of roads, such as 50m</source>
        <translation>No cortar nada a esta distancia de carreteras, p. ej. 50m</translation>
    </message>
    <message>
        <source>Ground within this of a road is not cut: 50m.</source>
        <translation>El terreno a esta distancia de una carretera no se corta: 50m.</translation>
    </message>
    <message>
        <source>Fire breaks</source>
        <translation>Cortafuegos</translation>
    </message>
    <message>
        <source>Fire breaks as polygons</source>
        <translation>Cortafuegos como polígonos</translation>
    </message>
    <message>
        <source>Segments to build, in order</source>
        <translation>Tramos por construir, en orden</translation>
    </message>
    <message>
        <source>Compartments between the breaks</source>
        <translation>Compartimentos entre los cortafuegos</translation>
    </message>
    <message>
        <source>The plan on one page: map, segments, doubt; opens in any browser</source>
        <translation>El plan en una página: mapa, tramos, incertidumbre; se abre en cualquier navegador</translation>
    </message>
    <message>
        <source>Cutting priority</source>
        <translation>Prioridad de corta</translation>
    </message>
    <message>
        <source>What each cell would keep of its spread once treated</source>
        <translation>Lo que conservaría cada celda de su propagación una vez tratada</translation>
    </message>
    <message>
        <source>Burn frequency without breaks</source>
        <translation>Frecuencia de quema sin cortafuegos</translation>
    </message>
    <message>
        <source>Burn frequency with the breaks</source>
        <translation>Frecuencia de quema con los cortafuegos</translation>
    </message>
    <message>
        <source>Existing breaks, what each is worth, and whether it is kept up</source>
        <translation>Cortafuegos existentes, lo que vale cada uno y si se mantiene</translation>
    </message>
    <message>
        <source>What the plan does for its goal and for all others</source>
        <translation>Lo que hace el plan por su objetivo y por todos los demás</translation>
    </message>
    <message>
        <source>What is built, kept up and burnt in each year</source>
        <translation>Lo que se construye, se mantiene y se quema cada año</translation>
    </message>
    <message>
        <source>Size of every fire without and with the breaks</source>
        <translation>Tamaño de cada incendio sin y con los cortafuegos</translation>
    </message>
    <message>
        <source>Burnt share at every budget</source>
        <translation>Proporción quemada con cada presupuesto</translation>
    </message>
    <message>
        <source>Cells burnt in every run of it</source>
        <translation>Celdas quemadas en cada ejecución de ello</translation>
    </message>
    <message>
        <source>Burnt share at every budget, without a clock and with perfect breaks</source>
        <translation>Proporción quemada con cada presupuesto, sin reloj y con cortafuegos perfectos</translation>
    </message>
    <message>
        <source>Picture of the plan</source>
        <translation>Imagen del plan</translation>
    </message>
    <message>
        <source>Rank cells</source>
        <translation>Ordenar celdas</translation>
    </message>
    <message>
        <source>Rank the cells of a spread network by the order in which they should be cut: higher is earlier.</source>
        <translation>Ordena las celdas de una red de propagación según cuándo se deben cortar: más alto es antes.</translation>
    </message>
    <message>
        <source>Rankings that lay a pattern for the budget give another order for another budget.</source>
        <translation>Los métodos que trazan un patrón para el presupuesto dan otro orden con otro presupuesto.</translation>
    </message>
    <message>
        <source>Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.</source>
        <translation>Ocho bandas con la probabilidad de que el fuego pase al N, NE, E, SE, S, SO, O y NO.</translation>
    </message>
    <message>
        <source>Elevation, for methods that follow ridges [m].</source>
        <translation>Elevación, para métodos que siguen crestas [m].</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: alike].</source>
        <translation>Con qué probabilidad empieza un incendio en cada celda, en relación con las demás [si no, igual].</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost".</source>
        <translation>Coste de corta por hectárea: un ráster, polígonos con "Campo con el coste".</translation>
    </message>
    <message>
        <source>Select fire breaks</source>
        <translation>Seleccionar cortafuegos</translation>
    </message>
    <message>
        <source>Cut the cells of highest priority, as many as the budget allows.</source>
        <translation>Corta las celdas de mayor prioridad, tantas como permite el presupuesto.</translation>
    </message>
    <message>
        <source>Ties are cut by row, then column. A priority that was made for another budget is warned of.</source>
        <translation>Los empates se cortan por fila y luego por columna. Se avisa de una prioridad hecha para otro presupuesto.</translation>
    </message>
    <message>
        <source>Score by which cells are cut, higher is earlier.</source>
        <translation>Puntuación según la cual se cortan las celdas, más alto es antes.</translation>
    </message>
    <message>
        <source>Cost per hectare, for budgets of money: a raster, or polygons with "Field with the cost".</source>
        <translation>Coste por hectárea, para presupuestos en dinero: un ráster, o polígonos con "Campo con el coste".</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority</source>
        <translation>Tomar un ráster que no se escribió como prioridad</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority all the same: its greatest numbers are cut first.</source>
        <translation>Toma a pesar de todo un ráster que no se escribió como prioridad: sus números mayores se cortan primero.</translation>
    </message>
    <message>
        <source>Segments to build</source>
        <translation>Tramos por construir</translation>
    </message>
    <message>
        <source>Take fire breaks apart into segments to build, best first.</source>
        <translation>Descompone los cortafuegos en tramos por construir, primero los mejores.</translation>
    </message>
    <message>
        <source>Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope and cost, and the share of all that the breaks save that it adds.</source>
        <translation>Cada tramo separa dos compartimentos de combustible y tiene un orden de construcción, longitud, anchura, superficie, pendiente media y coste, y la parte que añade a todo lo que ahorran los cortafuegos.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Tramos</translation>
    </message>
    <message>
        <source>Stages of construction</source>
        <translation>Etapas de construcción</translation>
    </message>
    <message>
        <source>Length in kilometres</source>
        <translation>Longitud en kilómetros</translation>
    </message>
    <message>
        <source>Cells that are cut: 1, all others 0.</source>
        <translation>Celdas cortadas: 1, todas las demás 0.</translation>
    </message>
    <message>
        <source>Ranking; decides between segments that save equally much.</source>
        <translation>Ordenación; decide entre tramos que ahorran lo mismo.</translation>
    </message>
    <message>
        <source>Elevation on any grid, for the slopes [m].</source>
        <translation>Elevación en cualquier cuadrícula, para las pendientes [m].</translation>
    </message>
    <message>
        <source>What of the segments goes into a format with one layer</source>
        <translation>Qué de los tramos va a un formato de una sola capa</translation>
    </message>
    <message>
        <source>Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].</source>
        <translation>Capa de los tramos que se escribe: líneas medias o contornos [si no, ambas en .gpkg, en otros las líneas].</translation>
    </message>
    <message>
        <source>Their middle lines</source>
        <translation>Sus líneas medias</translation>
    </message>
    <message>
        <source>Their outlines</source>
        <translation>Sus contornos</translation>
    </message>
    <message>
        <source>Map book for crews</source>
        <translation>Libro de mapas para las brigadas</translation>
    </message>
    <message>
        <source>Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, its ends, sizes, slope, cost and treatment, and what it is for.</source>
        <translation>Imprime un plan en PDF: una vista general, una lista de los tramos y una página para cada uno con un mapa a escala redonda, sus extremos, medidas, pendiente, coste y tratamiento, y para qué sirve.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the plan were written. Its segments alone do as well, without the vegetation; then the elevation is asked for.</source>
        <translation>Elija la carpeta en la que se escribieron todos los archivos del plan. También bastan sus tramos, sin la vegetación; entonces se pide la elevación.</translation>
    </message>
    <message>
        <source>Segments with a page</source>
        <translation>Tramos con página</translation>
    </message>
    <message>
        <source>Folder of the run</source>
        <translation>Carpeta de la ejecución</translation>
    </message>
    <message>
        <source>Into which a plan or a comparison was written with all its files.</source>
        <translation>En la que se escribió un plan o una comparación con todos sus archivos.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Title of the book [default: what the plan says of itself].</source>
        <translation>Título del libro [por defecto: lo que el plan dice de sí mismo].</translation>
    </message>
    <message>
        <source>Date, as it is to be shown</source>
        <translation>Fecha, tal como debe aparecer</translation>
    </message>
    <message>
        <source>Date of the data or the print, shown as it is given.</source>
        <translation>Fecha de los datos o de la impresión; aparece tal como se indica.</translation>
    </message>
    <message>
        <source>Roads to draw: lines or areas of any vector file.</source>
        <translation>Carreteras que se dibujan: líneas o áreas de cualquier archivo vectorial.</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw</source>
        <translation>Ríos y lagos que se dibujan</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw: lines or areas.</source>
        <translation>Ríos y lagos que se dibujan: líneas o áreas.</translation>
    </message>
    <message>
        <source>Most segments that get a page</source>
        <translation>Máximo de tramos con página</translation>
    </message>
    <message>
        <source>Segments that get a page, the first in order of construction; the list names all.</source>
        <translation>Tramos que reciben una página, los primeros en el orden de construcción; la lista los nombra todos.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Size of the paper.</source>
        <translation>Tamaño del papel.</translation>
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
        <translation>Carta</translation>
    </message>
    <message>
        <source>as its segments (segments.gpkg)</source>
        <translation>como sus tramos (segments.gpkg)</translation>
    </message>
    <message>
        <source>Elevation on any grid, beside segments alone; the folder of a plan has its own.</source>
        <translation>Elevación en cualquier malla, si solo se dan tramos; la carpeta de un plan tiene la suya.</translation>
    </message>
    <message>
        <source>Shorter segments get no page [m]</source>
        <translation>Los tramos más cortos no reciben página [m]</translation>
    </message>
    <message>
        <source>Segments shorter than this have no page of their own [m].</source>
        <translation>Los tramos más cortos que esto no tienen página propia [m].</translation>
    </message>
    <message>
        <source>Upright pages</source>
        <translation>Páginas verticales</translation>
    </message>
    <message>
        <source>Upright pages, the texts under the map.</source>
        <translation>Páginas verticales, con los textos bajo el mapa.</translation>
    </message>
    <message>
        <source>Map book</source>
        <translation>Libro de mapas</translation>
    </message>
    <message>
        <source>Files for crews</source>
        <translation>Archivos para las brigadas</translation>
    </message>
    <message>
        <source>Write segments, breaks or compartments of a plan in the format of a crew.</source>
        <translation>Escribe los tramos, cortafuegos o compartimentos de un plan en el formato de una brigada.</translation>
    </message>
    <message>
        <source>The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, .zip for a Shapefile, .geojson for the web.</source>
        <translation>La extensión del archivo lo elige: .kml para Google Earth y teléfonos, .gpx para aparatos GPS, .dxf para dibujos, .zip para un Shapefile, .geojson para la web.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>Segments, breaks or compartments of a plan (.gpkg)</source>
        <translation>Tramos, cortafuegos o compartimentos de un plan (.gpkg)</translation>
    </message>
    <message>
        <source>The segments.gpkg, breaks.gpkg or compartments.gpkg that a plan wrote.</source>
        <translation>El segments.gpkg, breaks.gpkg o compartments.gpkg que escribió un plan.</translation>
    </message>
    <message>
        <source>File for the crew</source>
        <translation>Archivo para la brigada</translation>
    </message>
    <message>
        <source>Burn frequency</source>
        <translation>Frecuencia de quema</translation>
    </message>
    <message>
        <source>Let many fires start and tell how often each cell burns.</source>
        <translation>Hace empezar muchos incendios y dice con qué frecuencia arde cada celda.</translation>
    </message>
    <message>
        <source>Fires with a duration need a network with times. With the same seed the fires are the same with and without breaks, so their difference is the breaks' work alone.</source>
        <translation>Los incendios con duración necesitan una red con tiempos. Con la misma semilla los incendios son los mismos con y sin cortafuegos, de modo que su diferencia se debe solo a los cortafuegos.</translation>
    </message>
    <message>
        <source>Mean burnt share</source>
        <translation>Proporción quemada media</translation>
    </message>
    <message>
        <source>Largest burnt share</source>
        <translation>Mayor proporción quemada</translation>
    </message>
    <message>
        <source>Mean fire in hectares</source>
        <translation>Incendio medio en hectáreas</translation>
    </message>
    <message>
        <source>Largest fire in hectares</source>
        <translation>Mayor incendio en hectáreas</translation>
    </message>
    <message>
        <source>Cut cells: a raster, or own breaks as polygons or lines.</source>
        <translation>Celdas cortadas: un ráster, o cortafuegos propios como polígonos o líneas.</translation>
    </message>
    <message>
        <source>Roads, rivers and the like on ground that the network holds as fuel; they stop fire as "How often a barrier holds" says.</source>
        <translation>Carreteras, ríos y similares sobre suelo que la red tiene por combustible; detienen el fuego como dice "Con qué frecuencia aguanta una barrera".</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: until they end by themselves].</source>
        <translation>Cuánto duran los incendios: 8h, una lista que las ejecuciones toman por turno (4h,8h), lognormal:8h,0.7 (mediana y sigma), uniform:2h,12h, o weather [si no, hasta que acaban por sí mismos].</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: always].</source>
        <translation>Con qué frecuencia aguanta un trozo de cortafuegos en una ejecución: una proporción (0.47 en el campo), flame (por anchura e intensidad del fuego, Wilson 1988) o flame:flames (1.5 longitudes de llama); los trozos tienen 400 m, o como en 0.47:800 [si no, siempre].</translation>
    </message>
    <message>
        <source>Take "Fire breaks" as lines of this width, such as 12m, or of the width in that column; they may be narrower than a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].</source>
        <translation>Toma "Cortafuegos" como líneas de esta anchura, p. ej. 12m, o de la anchura en esa columna; pueden ser más estrechas que una celda y detienen el fuego entre las celdas que separan [si no, las líneas toman cada celda que tocan].</translation>
    </message>
    <message>
        <source>What treated cells keep of their spread (kept.tif)</source>
        <translation>Lo que conservan de su propagación las celdas tratadas (kept.tif)</translation>
    </message>
    <message>
        <source>What each cell keeps of its spread probability once it is treated, in place of one "Share of the spread that a break lets through" for all: kept.tif of a plan with treatments.</source>
        <translation>Lo que conserva cada celda de su probabilidad de propagación una vez tratada, en lugar de una sola "Proporción de la propagación que deja pasar un cortafuegos" para todas: kept.tif de un plan con tratamientos.</translation>
    </message>
    <message>
        <source>Side of the windows in which a large map is read [cells]</source>
        <translation>Lado de las ventanas en que se lee un mapa grande [celdas]</translation>
    </message>
    <message>
        <source>Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire needs it, so that maps larger than the memory can burn; the fires are the same.</source>
        <translation>Lee el mapa por ventanas de este lado (una potencia de dos, p. ej. 512) en torno a cada incendio, mayores donde un incendio lo necesita, para que puedan arder mapas mayores que la memoria; los incendios son los mismos.</translation>
    </message>
    <message>
        <source>Times for the folder of arrival times, such as 2h,4h</source>
        <translation>Tiempos para la carpeta de tiempos de llegada, p. ej. 2h,4h</translation>
    </message>
    <message>
        <source>Times for "Folder for arrival times".</source>
        <translation>Tiempos para "Carpeta para tiempos de llegada".</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes [hectares]</source>
        <translation>Límites de las clases de tamaño de incendio [hectáreas]</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes for "Folder for arrival times", in hectares.</source>
        <translation>Límites de las clases de tamaño de incendio para "Carpeta para tiempos de llegada", en hectáreas.</translation>
    </message>
    <message>
        <source>Flame lengths for the folder of arrival times [m]</source>
        <translation>Longitudes de llama para la carpeta de tiempos de llegada [m]</translation>
    </message>
    <message>
        <source>Flame lengths for "Folder for arrival times", in metres; left out if the network knows no heat.</source>
        <translation>Longitudes de llama para "Carpeta para tiempos de llegada", en metros; se omiten si la red no conoce el calor.</translation>
    </message>
    <message>
        <source>Fire sizes</source>
        <translation>Tamaños de incendio</translation>
    </message>
    <message>
        <source>Folder for arrival times, isochrones and more</source>
        <translation>Carpeta para tiempos de llegada, isócronas y más</translation>
    </message>
    <message>
        <source>Judge existing breaks</source>
        <translation>Valorar cortafuegos existentes</translation>
    </message>
    <message>
        <source>Tell what each existing fire break is worth, and which gap between breaks matters most.</source>
        <translation>Dice cuánto vale cada cortafuegos existente y qué hueco entre cortafuegos importa más.</translation>
    </message>
    <message>
        <source>The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are the work of that break alone. The same break at random places stands beside it. The network must hold the fuel that lies on the breaks.</source>
        <translation>Los mismos incendios arden con todos los cortafuegos, sin cada uno de ellos y con cada hueco cerrado, de modo que las diferencias se deben solo a ese cortafuegos. A su lado está el mismo cortafuegos en lugares al azar. La red debe contener el combustible que hay sobre los cortafuegos.</translation>
    </message>
    <message>
        <source>Longest gap that is looked at [m]</source>
        <translation>Hueco más largo que se considera [m]</translation>
    </message>
    <message>
        <source>Length of the longest gap that is looked at, in metres.</source>
        <translation>Longitud del hueco más largo que se considera, en metros.</translation>
    </message>
    <message>
        <source>Most gaps that are looked at</source>
        <translation>Número máximo de huecos que se consideran</translation>
    </message>
    <message>
        <source>Number of gaps looked at, the shortest.</source>
        <translation>Número de huecos que se consideran, los más cortos.</translation>
    </message>
    <message>
        <source>Random places to compare each break with</source>
        <translation>Lugares al azar con los que se compara cada cortafuegos</translation>
    </message>
    <message>
        <source>Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.</source>
        <translation>Número de lugares al azar en que se prueban también cada cortafuegos y cada hueco, para comparar; 0 los deja fuera.</translation>
    </message>
    <message>
        <source>Breaks with what each is worth, and gaps with what closing them saves</source>
        <translation>Cortafuegos con lo que vale cada uno, y huecos con lo que ahorra cerrarlos</translation>
    </message>
    <message>
        <source>What each break is worth</source>
        <translation>Cuánto vale cada cortafuegos</translation>
    </message>
    <message>
        <source>What closing each gap saves</source>
        <translation>Cuánto ahorra cerrar cada hueco</translation>
    </message>
    <message>
        <source>What stands and what is missing, in words</source>
        <translation>Lo que hay y lo que falta, en palabras</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Evaluar</translation>
    </message>
    <message>
        <source>Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.</source>
        <translation>Juzga los métodos de ordenación: media, percentil 90 % y máximo de la proporción quemada con cada presupuesto.</translation>
    </message>
    <message>
        <source>All rankings meet the same fires, and each plan is made for its budget.</source>
        <translation>Todos los métodos se enfrentan a los mismos incendios, y cada plan se hace para su presupuesto.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Métodos</translation>
    </message>
    <message>
        <source>Methods to hold against each other; all rankings are described below.</source>
        <translation>Métodos que se comparan entre sí; todos los de ordenación se describen abajo.</translation>
    </message>
    <message>
        <source>Ranking to test against</source>
        <translation>Método con el que se contrasta</translation>
    </message>
    <message>
        <source>Ranking that the others are tested against.</source>
        <translation>Método con el que se contrastan los demás.</translation>
    </message>
    <message>
        <source>Budgets, such as 5%, 10%</source>
        <translation>Presupuestos, p. ej. 5%, 10%</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: 0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</source>
        <translation>Cuánto cortar, separado por comas: proporciones del combustible como 5% o 0.05, o superficies como 20ha [si no, de 0 a 0.4 en pasos de 0.01; donde cada presupuesto se quema de nuevo, con reloj o cortafuegos que fallan, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prueba</translation>
    </message>
    <message>
        <source>Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.</source>
        <translation>Wilcoxon de rangos con signo por pares, Wilcoxon de suma de rangos para ejecuciones independientes, o t por pares.</translation>
    </message>
    <message>
        <source>Wilcoxon's signed-rank test of pairs</source>
        <translation>Prueba de Wilcoxon de rangos con signo, por pares</translation>
    </message>
    <message>
        <source>Wilcoxon's rank-sum test of independent runs</source>
        <translation>Prueba de Wilcoxon de suma de rangos, ejecuciones independientes</translation>
    </message>
    <message>
        <source>Student's t-test of pairs</source>
        <translation>Prueba t de Student, por pares</translation>
    </message>
    <message>
        <source>Significance threshold</source>
        <translation>Umbral de significación</translation>
    </message>
    <message>
        <source>Significance threshold.</source>
        <translation>Umbral de significación.</translation>
    </message>
    <message>
        <source>Burnt share and significance of every ranking at every budget</source>
        <translation>Proporción quemada y significación de cada método con cada presupuesto</translation>
    </message>
    <message>
        <source>Cells burnt in every run, from which each p-value can be found again</source>
        <translation>Celdas quemadas en cada ejecución, con las que se puede volver a hallar cada valor p</translation>
    </message>
    <message>
        <source>Curves of the burnt share</source>
        <translation>Curvas de la proporción quemada</translation>
    </message>
    <message>
        <source>Curves of the burnt share, to scale</source>
        <translation>Curvas de la proporción quemada, escalables</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with intervals.</source>
        <translation>Compara planes: superficie quemada esperada, valor perdido, peores incendios y hectáreas salvadas por hectárea cortada, con intervalos.</translation>
    </message>
    <message>
        <source>The fires are fresh: no plan was designed with them, and all burn in the same ones.</source>
        <translation>Los incendios son nuevos: ningún plan se diseñó con ellos, y todos se prueban con los mismos.</translation>
    </message>
    <message>
        <source>Lines: walls as wide as a cell and at most 30 m, of which plans are made by default</source>
        <translation>Líneas: muros de la anchura de una celda y como mucho 30 m, de los que se hacen los planes por defecto</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.</source>
        <translation>Cuánto cortar, separado por comas: proporciones del combustible como 5% o 0.05, o superficies como 20ha.</translation>
    </message>
    <message>
        <source>Shares that breaks let through, separated by commas</source>
        <translation>Proporciones que dejan pasar los cortafuegos, separadas por comas</translation>
    </message>
    <message>
        <source>Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.</source>
        <translation>Proporciones de su probabilidad de propagación que conserva una celda tratada, separadas por comas; 0 es perfecto.</translation>
    </message>
    <message>
        <source>Fires expected until the breaks have grown back</source>
        <translation>Incendios esperados hasta que los cortafuegos se hayan cerrado</translation>
    </message>
    <message>
        <source>Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so often when it is held against what they cost.</source>
        <translation>Número de incendios que encuentran los cortafuegos antes de que se cierren; lo que ahorran en un incendio cuenta tantas veces cuando se compara con lo que cuestan.</translation>
    </message>
    <message>
        <source>The comparison on one page; opens in any browser</source>
        <translation>La comparación en una página; se abre en cualquier navegador</translation>
    </message>
    <message>
        <source>Every plan at every budget and leak, with intervals</source>
        <translation>Cada plan con cada presupuesto y cada fuga, con intervalos</translation>
    </message>
    <message>
        <source>Curves of the plans</source>
        <translation>Curvas de los planes</translation>
    </message>
    <message>
        <source>Curves of the plans, to scale</source>
        <translation>Curvas de los planes, escalables</translation>
    </message>
    <message>
        <source>What each step of each plan costs and saves</source>
        <translation>Lo que cuesta y ahorra cada paso de cada plan</translation>
    </message>
    <message>
        <source>Saved against paid, and where the next hectare stops paying</source>
        <translation>Lo ahorrado frente a lo pagado, y dónde deja de compensar la hectárea siguiente</translation>
    </message>
    <message>
        <source>Validate against a scar</source>
        <translation>Validar con un área quemada</translation>
    </message>
    <message>
        <source>Hold a simulated fire against the area that burnt, beside fires that know nothing.</source>
        <translation>Compara un incendio simulado con el área que ardió, junto a incendios que no saben nada.</translation>
    </message>
    <message>
        <source>Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.</source>
        <translation>Para el incendio simulado y para los modelos nulos (sin crecimiento, igual distancia en el combustible, una elipse en el viento) se dan el índice de Sørensen, el IoU, el IoU del crecimiento solo, el tamaño, la puntuación de Brier y la fiabilidad.</translation>
    </message>
    <message>
        <source>Observed hectares</source>
        <translation>Hectáreas observadas</translation>
    </message>
    <message>
        <source>Simulated hectares</source>
        <translation>Hectáreas simuladas</translation>
    </message>
    <message>
        <source>Area that burnt</source>
        <translation>Área quemada</translation>
    </message>
    <message>
        <source>Perimeter of the fire as polygons, or a raster above 0 where it burnt.</source>
        <translation>Perímetro del incendio como polígonos, o un ráster mayor que 0 donde ardió.</translation>
    </message>
    <message>
        <source>Where the fire was first seen</source>
        <translation>Dónde se vio el incendio primero</translation>
    </message>
    <message>
        <source>Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.</source>
        <translation>Dónde se vio el incendio primero: puntos, o polígonos que ya ardían (cualquier archivo vectorial), o un ráster.</translation>
    </message>
    <message>
        <source>How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.</source>
        <translation>Cuánto tiempo se propagó el incendio, p. ej. 3h; lognormal:3h,0.5 (mediana, sigma) donde no se sabe bien.</translation>
    </message>
    <message>
        <source>Number of simulated fires.</source>
        <translation>Número de incendios simulados.</translation>
    </message>
    <message>
        <source>Scores of the simulated fire and of the null models</source>
        <translation>Puntuaciones del incendio simulado y de los modelos nulos</translation>
    </message>
    <message>
        <source>How often cells burnt, by the probability forecast</source>
        <translation>Con qué frecuencia ardieron las celdas, según la probabilidad prevista</translation>
    </message>
    <message>
        <source>Share of the simulated fires in which each cell burns</source>
        <translation>Proporción de los incendios simulados en que arde cada celda</translation>
    </message>
    <message>
        <source>Picture of the simulated fire over the scar, with the reliability</source>
        <translation>Imagen del incendio simulado sobre el área quemada, con la fiabilidad</translation>
    </message>
    <message>
        <source>Calibrate on observed fires</source>
        <translation>Calibrar con incendios observados</translation>
    </message>
    <message>
        <source>Fit the rate of spread, durations and spread probability to the fires of a region.</source>
        <translation>Ajusta la velocidad de propagación, las duraciones y la probabilidad de propagación a los incendios de una región.</translation>
    </message>
    <message>
        <source>The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in which they burn. More numbers than the fires can tell are refused.</source>
        <translation>Los incendios son polígonos o una tabla con sus tamaños y, si se saben, sus días; la meteorología dice los vientos en que arden. Se rechaza ajustar más números de los que los incendios permiten.</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Incendios</translation>
    </message>
    <message>
        <source>Numbers fitted</source>
        <translation>Números ajustados</translation>
    </message>
    <message>
        <source>Observed fires with sizes and days</source>
        <translation>Incendios observados con tamaños y días</translation>
    </message>
    <message>
        <source>Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.</source>
        <translation>Polígonos o una tabla (CSV) de los incendios de una región, con sus tamaños en hectáreas y, si se saben, sus días.</translation>
    </message>
    <message>
        <source>What to fit: rate, duration, p0</source>
        <translation>Qué ajustar: rate, duration, p0</translation>
    </message>
    <message>
        <source>What to fit: rate, duration and p0, separated by commas [default: rate and duration; of fewer than three scars the rate alone].</source>
        <translation>Qué ajustar: rate, duration y p0, separados por comas [si no, rate y duration; con menos de tres áreas quemadas, rate solo].</translation>
    </message>
    <message>
        <source>Smallest fire that counts [hectares]</source>
        <translation>Menor incendio que cuenta [hectáreas]</translation>
    </message>
    <message>
        <source>Fires of fewer hectares do not count: small ones are often not mapped.</source>
        <translation>Los incendios de menos hectáreas no cuentan: los pequeños a menudo no están cartografiados.</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: everywhere alike].</source>
        <translation>Con qué probabilidad empieza un incendio en cada celda, en relación con las demás [si no, igual en todas partes].</translation>
    </message>
    <message>
        <source>Column with the size in hectares</source>
        <translation>Columna con el tamaño en hectáreas</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the size in hectares [default: found by name].</source>
        <translation>Columna de "Incendios observados con tamaños y días" con el tamaño en hectáreas [si no, se halla por el nombre].</translation>
    </message>
    <message>
        <source>Column with the first day</source>
        <translation>Columna con el primer día</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the first day [default: found by name].</source>
        <translation>Columna de "Incendios observados con tamaños y días" con el primer día [si no, se halla por el nombre].</translation>
    </message>
    <message>
        <source>Column with the last day</source>
        <translation>Columna con el último día</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the last day [default: found by name].</source>
        <translation>Columna de "Incendios observados con tamaños y días" con el último día [si no, se halla por el nombre].</translation>
    </message>
    <message>
        <source>Time of spread on each day of a fire [hours]</source>
        <translation>Tiempo de propagación en cada día de un incendio [horas]</translation>
    </message>
    <message>
        <source>Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.</source>
        <translation>Horas que un incendio se propaga en cada uno de sus días; un supuesto que distingue velocidades de duraciones.</translation>
    </message>
    <message>
        <source>Longest simulated fire, such as 200h</source>
        <translation>Mayor duración de un incendio simulado, p. ej. 200h</translation>
    </message>
    <message>
        <source>No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].</source>
        <translation>Ningún incendio se propaga más tiempo [si no, tantos días enteros como el incendio observado más largo, o 200h].</translation>
    </message>
    <message>
        <source>Parameter of the spread model that stays as it is, e.g. moisture=0.06; several are separated by ;.</source>
        <translation>Parámetro del modelo de propagación que queda como está, p. ej. moisture=0.06; varios se separan con ;.</translation>
    </message>
    <message>
        <source>Calibration, which other forms take</source>
        <translation>Calibración, que toman otros formularios</translation>
    </message>
    <message>
        <source>What is told of each fire</source>
        <translation>Lo que se dice de cada incendio</translation>
    </message>
    <message>
        <source>Report of a run</source>
        <translation>Informe de una ejecución</translation>
    </message>
    <message>
        <source>Show a plan or a comparison on one page: map, segments, curve, assumptions, files.</source>
        <translation>Muestra un plan o una comparación en una página: mapa, tramos, curva, supuestos, archivos.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the run were written. The page opens in any browser without a network. Its links lead to files beside the page, so write it into that folder.</source>
        <translation>Elija la carpeta en la que se escribieron todos los archivos de la ejecución. La página se abre en cualquier navegador sin red. Sus enlaces llevan a archivos junto a la página, así que escríbala en esa carpeta.</translation>
    </message>
    <message>
        <source>The run on one page</source>
        <translation>La ejecución en una página</translation>
    </message>
    <message>
        <source>{} was not made: there is nothing to put in it.</source>
        <translation>{} no se hizo: no hay nada que poner en él.</translation>
    </message>
    <message>
        <source>Stopped; no output was written.</source>
        <translation>Detenido; no se escribió ninguna salida.</translation>
    </message>
    <message>
        <source>Report: {} (open it from the Results Viewer)</source>
        <translation>Informe: {} (ábralo desde el visor de resultados)</translation>
    </message>
    <message>
        <source>[not chosen]</source>
        <translation>[sin elegir]</translation>
    </message>
    <message>
        <source>{} holds {}; only a GeoPackage can hold {} as well.</source>
        <translation>{} contiene {}; solo un GeoPackage puede contener también {}.</translation>
    </message>
    <message>
        <source>The layer {} cannot be read as cells of a raster.</source>
        <translation>La capa {} no se puede leer como celdas de un ráster.</translation>
    </message>
    <message>
        <source>An extent needs the CRS of the grid; choose it beside the extent (CRS).</source>
        <translation>Una extensión necesita el SRC de la cuadrícula; elíjalo junto a la extensión (SRC).</translation>
    </message>
    <message>
        <source>Making the engine of Firebreak</source>
        <translation>Creando el motor de Firebreak</translation>
    </message>
    <message>
        <source>firebreak_gis {} is ready.</source>
        <translation>firebreak_gis {} está listo.</translation>
    </message>
    <message>
        <source>firebreak_gis {} answers: {} ({})</source>
        <translation>firebreak_gis {} responde: {} ({})</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Python with firebreak_gis, or the firebreak program</source>
        <translation>Python con firebreak_gis, o el programa firebreak</translation>
    </message>
    <message>
        <source>empty: found by itself</source>
        <translation>vacío: se busca solo</translation>
    </message>
    <message>
        <source>Python or program</source>
        <translation>Python o programa</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Make an engine</source>
        <translation>Crear un motor</translation>
    </message>
    <message>
        <source>Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The Python of QGIS is left alone, and an engine made before stays until the new one answers. Nothing is installed until you press the button.</source>
        <translation>Crea un entorno de Python en su perfil de QGIS, de unos 900 MB, e instala en él firebreak_gis: desde el índice de paquetes (por el proxy de QGIS), o desde la ruta de un clon o de un wheel. El Python de QGIS no se toca, y un motor creado antes se queda hasta que el nuevo responda. No se instala nada hasta que pulse el botón.</translation>
    </message>
    <message>
        <source>empty: the newest of 3.11 to 3.13 found</source>
        <translation>vacío: el más nuevo de 3.11 a 3.13 que se encuentre</translation>
    </message>
    <message>
        <source>Python to make it from</source>
        <translation>Python con el que se crea</translation>
    </message>
    <message>
        <source>A name in the index, or the path of a clone or a wheel.</source>
        <translation>Un nombre del índice, o la ruta de un clon o de un wheel.</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Paquete</translation>
    </message>
    <message>
        <source>Make engine</source>
        <translation>Crear motor</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Firebreak settings…</source>
        <translation>Ajustes de Firebreak…</translation>
    </message>
    <message>
        <source>Firebreak</source>
        <translation>Firebreak</translation>
    </message>
    <message>
        <source>Firebreak (plan forest fire breaks)</source>
        <translation>Firebreak (planificar cortafuegos forestales)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Salidas</translation>
    </message>
</context>
</TS>
