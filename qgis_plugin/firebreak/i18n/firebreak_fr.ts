<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Firebreak</name>
    <message>
        <source>1 Prepare</source>
        <translation>1 Préparer</translation>
    </message>
    <message>
        <source>2 Rank and cut</source>
        <translation>2 Classer et couper</translation>
    </message>
    <message>
        <source>3 Burn</source>
        <translation>3 Brûler</translation>
    </message>
    <message>
        <source>4 Judge</source>
        <translation>4 Juger</translation>
    </message>
    <message>
        <source>Align landscape</source>
        <translation>Aligner le paysage</translation>
    </message>
    <message>
        <source>Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.</source>
        <translation>Place altitude, végétation et densité sur une grille carrée commune en mètres, les codes traduits en classes de combustible.</translation>
    </message>
    <message>
        <source>The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape (.lcp) as elevation holds all layers.</source>
        <translation>Les couches peuvent avoir n'importe quel SCR, emprise et taille de cellule ; elles sont placées sur une grille carrée en mètres. La densité peut être un raster, un mot pour tout le combustible (à quel point il est fermé), ou manquer si la légende la donne. Un paysage FlamMap (.lcp) comme altitude contient toutes les couches.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <source>Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.</source>
        <translation>Altitude en mètres, dans tout SCR et toute taille de cellule ; ou un fichier de paysage (.lcp), qui contient toutes les couches.</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Végétation</translation>
    </message>
    <message>
        <source>Codes of the vegetation, explained by the legend.</source>
        <translation>Codes de la végétation, expliqués par la légende.</translation>
    </message>
    <message>
        <source>Vegetation density</source>
        <translation>Densité de la végétation</translation>
    </message>
    <message>
        <source>Codes of the density of the vegetation; without it the densities come from the legend.</source>
        <translation>Codes de la densité de la végétation ; sans eux les densités viennent de la légende.</translation>
    </message>
    <message>
        <source>Legend of the vegetation codes</source>
        <translation>Légende des codes de végétation</translation>
    </message>
    <message>
        <source>What the vegetation codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Ce que veulent dire les codes de végétation : une légende fournie, ou un fichier CSV à vous.</translation>
    </message>
    <message>
        <source>Fuel models of Anderson 1982</source>
        <translation>Modèles de combustible d'Anderson 1982</translation>
    </message>
    <message>
        <source>Canopy cover in percent as density: below 40 sparse, below 70 normal, else dense</source>
        <translation>Couvert des houppiers en pour cent comme densité : clairsemé sous 40, normal sous 70, sinon dense</translation>
    </message>
    <message>
        <source>CORINE Land Cover, level 3, three-digit codes</source>
        <translation>CORINE Land Cover, niveau 3, codes à trois chiffres</translation>
    </message>
    <message>
        <source>CORINE Land Cover as the raster of the European Environment Agency holds it: grid codes 1 to 44 in the order of level 3</source>
        <translation>CORINE Land Cover comme raster de l'Agence européenne pour l'environnement : codes 1 à 44 dans l'ordre du niveau 3</translation>
    </message>
    <message>
        <source>Vegetation densities of Russo, Russo, Siettos 2016</source>
        <translation>Densités de végétation de Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Fuel map of Europe in 12 classes, as the PROPAGATOR fire model uses it</source>
        <translation>Carte des combustibles d'Europe en 12 classes, telle que l'utilise le modèle de feu PROPAGATOR</translation>
    </message>
    <message>
        <source>Fuel types of the Canadian Forest Fire Behavior Prediction System</source>
        <translation>Types de combustible du Canadian Forest Fire Behavior Prediction System</translation>
    </message>
    <message>
        <source>Fuel models of Portugal</source>
        <translation>Modèles de combustible du Portugal</translation>
    </message>
    <message>
        <source>Fuel models of the Chilean Kitral system, codes as in Cell2Fire</source>
        <translation>Modèles de combustible du système chilien Kitral, codes comme dans Cell2Fire</translation>
    </message>
    <message>
        <source>Vegetation types of Russo, Russo, Siettos 2016</source>
        <translation>Types de végétation de Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Vegetation of the PROPAGATOR fire model in 7 classes</source>
        <translation>Végétation du modèle de feu PROPAGATOR en 7 classes</translation>
    </message>
    <message>
        <source>Fire behaviour fuel models of Scott and Burgan 2005</source>
        <translation>Modèles de combustible de Scott et Burgan 2005</translation>
    </message>
    <message>
        <source>Tree cover density in percent</source>
        <translation>Densité du couvert arboré en pour cent</translation>
    </message>
    <message>
        <source>ESA WorldCover 10 m, codes of releases 2020 v100 and 2021 v200</source>
        <translation>ESA WorldCover 10 m, codes des versions 2020 v100 et 2021 v200</translation>
    </message>
    <message>
        <source>as one class for all fuel</source>
        <translation>comme une seule classe pour tout le combustible</translation>
    </message>
    <message>
        <source>Sparse everywhere</source>
        <translation>Clairsemée partout</translation>
    </message>
    <message>
        <source>Normal everywhere</source>
        <translation>Normale partout</translation>
    </message>
    <message>
        <source>Dense everywhere</source>
        <translation>Dense partout</translation>
    </message>
    <message>
        <source>As closed as the fuel around each cell is</source>
        <translation>Aussi fermée que le combustible autour de chaque cellule</translation>
    </message>
    <message>
        <source>as a CSV file</source>
        <translation>comme fichier CSV</translation>
    </message>
    <message>
        <source>Creation options, such as COMPRESS=ZSTD</source>
        <translation>Options de création, p. ex. COMPRESS=ZSTD</translation>
    </message>
    <message>
        <source>Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.</source>
        <translation>Option de création du pilote COG de GDAL, p. ex. COMPRESS=ZSTD.</translation>
    </message>
    <message>
        <source>Legend of the density codes</source>
        <translation>Légende des codes de densité</translation>
    </message>
    <message>
        <source>What the density codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Ce que veulent dire les codes de densité : une légende fournie, ou un fichier CSV à vous.</translation>
    </message>
    <message>
        <source>CRS of the grid</source>
        <translation>SCR de la grille</translation>
    </message>
    <message>
        <source>CRS of the grid, projected in metres [default: the "Elevation"'s if it is in metres, else the UTM zone].</source>
        <translation>SCR de la grille, projeté en mètres [sinon celui de "Altitude" s'il est en mètres, ou la zone UTM].</translation>
    </message>
    <message>
        <source>Cell size [m]</source>
        <translation>Taille de cellule [m]</translation>
    </message>
    <message>
        <source>Cell size [default: the "Elevation"'s].</source>
        <translation>Taille de cellule [sinon celle de "Altitude"].</translation>
    </message>
    <message>
        <source>Extent (needs the CRS of the grid)</source>
        <translation>Emprise (demande le SCR de la grille)</translation>
    </message>
    <message>
        <source>Extent in the CRS of the grid [default: what all layers cover].</source>
        <translation>Emprise dans le SCR de la grille [sinon ce que toutes les couches couvrent].</translation>
    </message>
    <message>
        <source>Take the grid of this raster</source>
        <translation>Prendre la grille de ce raster</translation>
    </message>
    <message>
        <source>Take the grid of this raster.</source>
        <translation>Prend la grille de ce raster.</translation>
    </message>
    <message>
        <source>True CRS of the layers, such as dem=EPSG:32635</source>
        <translation>SCR véritable des couches, p. ex. dem=EPSG:32635</translation>
    </message>
    <message>
        <source>The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.</source>
        <translation>Le SCR véritable de dem, vegetation ou density, ou de tous, où un fichier n'en dit aucun ou un faux.</translation>
    </message>
    <message>
        <source>No-data values, such as dem=-9999; vegetation=255</source>
        <translation>Valeurs sans données, p. ex. dem=-9999; vegetation=255</translation>
    </message>
    <message>
        <source>Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says that all are data; several are separated by ;.</source>
        <translation>Valeurs qui veulent dire sans données dans dem, vegetation ou density, p. ex. dem=-9999,32767 ; dem=none dit que toutes sont des données ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>Bands, such as dem=1; vegetation=2</source>
        <translation>Bandes, p. ex. dem=1; vegetation=2</translation>
    </message>
    <message>
        <source>Band to read of dem, vegetation or density.</source>
        <translation>Bande à lire de dem, vegetation ou density.</translation>
    </message>
    <message>
        <source>Codes that the legend does not list</source>
        <translation>Codes absents de la légende</translation>
    </message>
    <message>
        <source>What to do with codes that the legend does not list.</source>
        <translation>Que faire des codes absents de la légende.</translation>
    </message>
    <message>
        <source>Refuse them</source>
        <translation>Les refuser</translation>
    </message>
    <message>
        <source>Take them as land without fuel</source>
        <translation>Les prendre comme sol sans combustible</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of</source>
        <translation>Refuser ce dont on ne ferait qu'avertir</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of.</source>
        <translation>Refuse ce dont on ne ferait qu'avertir.</translation>
    </message>
    <message>
        <source>Allow network addresses and archives</source>
        <translation>Permettre des adresses réseau et des archives</translation>
    </message>
    <message>
        <source>Allow "Elevation", "Vegetation" and "Vegetation density" to be network addresses or in archives.</source>
        <translation>Permet que "Altitude", "Végétation" et "Densité de la végétation" soient des adresses réseau ou dans des archives.</translation>
    </message>
    <message>
        <source>Most memory to use, such as 4GB</source>
        <translation>Mémoire maximale, p. ex. 4GB</translation>
    </message>
    <message>
        <source>Refuse work that needs more, e.g. 4GB [default: most of what there is].</source>
        <translation>Refuse un travail qui en demande plus, p. ex. 4GB [sinon la plus grande part de ce qu'il y a].</translation>
    </message>
    <message>
        <source>Calibration, or the account (run.json) of an earlier run</source>
        <translation>Calage, ou compte rendu (run.json) d'un passage antérieur</translation>
    </message>
    <message>
        <source>Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.</source>
        <translation>Prend des paramètres d'un fichier TOML, ou du run.json d'un passage antérieur ; ce qui est donné ici l'emporte.</translation>
    </message>
    <message>
        <source>Elevation on the common grid</source>
        <translation>Altitude sur la grille commune</translation>
    </message>
    <message>
        <source>Vegetation classes on the common grid</source>
        <translation>Classes de végétation sur la grille commune</translation>
    </message>
    <message>
        <source>Density classes on the common grid</source>
        <translation>Classes de densité sur la grille commune</translation>
    </message>
    <message>
        <source>Effect of the vegetation, where the legend gives numbers in place of classes</source>
        <translation>Effet de la végétation, où la légende donne des nombres au lieu de classes</translation>
    </message>
    <message>
        <source>Effect of the density, where the legend gives numbers in place of classes</source>
        <translation>Effet de la densité, où la légende donne des nombres au lieu de classes</translation>
    </message>
    <message>
        <source>Rate of spread on flat calm dry ground, where the legend gives it</source>
        <translation>Vitesse de propagation sur sol plat et sec sans vent, où la légende la donne</translation>
    </message>
    <message>
        <source>Load of dead fuel, where the legend gives it</source>
        <translation>Charge de combustible mort, où la légende la donne</translation>
    </message>
    <message>
        <source>Load of live fuel, where the legend gives it</source>
        <translation>Charge de combustible vivant, où la légende la donne</translation>
    </message>
    <message>
        <source>Heat content of the fuel, where the legend gives it</source>
        <translation>Pouvoir calorifique du combustible, où la légende le donne</translation>
    </message>
    <message>
        <source>Moisture of the live fuel, where the legend gives it</source>
        <translation>Teneur en eau du combustible vivant, où la légende la donne</translation>
    </message>
    <message>
        <source>Account of the run</source>
        <translation>Compte rendu du passage</translation>
    </message>
    <message>
        <source>Folder for all files</source>
        <translation>Dossier pour tous les fichiers</translation>
    </message>
    <message>
        <source>Spread network</source>
        <translation>Réseau de propagation</translation>
    </message>
    <message>
        <source>Find how likely fire spreads from each cell to its neighbours.</source>
        <translation>Trouve avec quelle probabilité le feu passe de chaque cellule à ses voisines.</translation>
    </message>
    <message>
        <source>Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). Wind and slope then act on the times; so make a network without times for fires without a duration.</source>
        <translation>Les bandes 1 à 8 contiennent la probabilité que le feu passe vers N, NE, E, SE, S, SO, O et NO. Si les temps sont donnés aussi, les bandes 9 à 16 contiennent les secondes que cela prend, et la bande 17 la chaleur que libère la cellule (kJ/m2). Le vent et la pente agissent alors sur les temps ; pour des feux sans durée, faites donc un réseau sans temps.</translation>
    </message>
    <message>
        <source>Cells with fuel</source>
        <translation>Cellules avec combustible</translation>
    </message>
    <message>
        <source>Spread model</source>
        <translation>Modèle de propagation</translation>
    </message>
    <message>
        <source>How fire gets from a cell to its neighbours; all are described below.</source>
        <translation>Comment le feu va d'une cellule à ses voisines ; tous sont décrits plus bas.</translation>
    </message>
    <message>
        <source>Alexandridis: cellular automaton of vegetation type, density, slope and wind</source>
        <translation>Alexandridis : automate cellulaire du type de végétation, de la densité, de la pente et du vent</translation>
    </message>
    <message>
        <source>Artificial forest: the probability of catching fire is the fuel of the target cell</source>
        <translation>Forêt artificielle : la probabilité de prendre feu est le combustible de la cellule visée</translation>
    </message>
    <message>
        <source>Raster: your own probabilities, and perhaps travel times, from another fire model</source>
        <translation>Raster : vos propres probabilités, et s'il y en a vos temps, d'un autre modèle de feu</translation>
    </message>
    <message>
        <source>Wind speed [m/s]</source>
        <translation>Vitesse du vent [m/s]</translation>
    </message>
    <message>
        <source>Wind speed at mid-flame height in m/s, or a raster of it on any grid.</source>
        <translation>Vitesse du vent à mi-hauteur de flamme en m/s, ou un raster de celle-ci sur toute grille.</translation>
    </message>
    <message>
        <source>Wind from [degrees clockwise from north]</source>
        <translation>Vent de [degrés dans le sens horaire depuis le nord]</translation>
    </message>
    <message>
        <source>Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.</source>
        <translation>Direction d'où vient le vent, dans le sens horaire depuis le nord : 270 est un vent d'ouest ; un nombre ou un raster.</translation>
    </message>
    <message>
        <source>Tell times too (for fires with a duration)</source>
        <translation>Donner aussi les temps (pour des feux avec une durée)</translation>
    </message>
    <message>
        <source>Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.</source>
        <translation>Donne aussi combien de temps le feu met de cellule en cellule (bandes 9 à 16, secondes) et la chaleur de chaque cellule.</translation>
    </message>
    <message>
        <source>as a raster</source>
        <translation>comme raster</translation>
    </message>
    <message>
        <source>Wind towards east and north, in place of speed and direction [m/s]</source>
        <translation>Vent vers l'est et le nord, au lieu de la vitesse et de la direction [m/s]</translation>
    </message>
    <message>
        <source>Components of the wind towards east and north, in place of the two above: rasters on any grid.</source>
        <translation>Composantes du vent vers l'est et le nord, à la place des deux ci-dessus : rasters sur toute grille.</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel (8 % is 0.08)</source>
        <translation>Teneur en eau du combustible mort fin (8 % s'écrit 0.08)</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.</source>
        <translation>Teneur en eau du combustible mort fin, en part de son poids sec (8 % s'écrit 0.08 ou 8%), ou un raster de celle-ci.</translation>
    </message>
    <message>
        <source>Neighbours that a cell can light</source>
        <translation>Voisines qu'une cellule peut enflammer</translation>
    </message>
    <message>
        <source>Cells to which fire can spread from a cell.</source>
        <translation>Cellules où le feu peut passer depuis une cellule.</translation>
    </message>
    <message>
        <source>All eight</source>
        <translation>Toutes les huit</translation>
    </message>
    <message>
        <source>The four that share a side</source>
        <translation>Les quatre qui partagent un côté</translation>
    </message>
    <message>
        <source>Parameters of the spread model, such as p0=0.5</source>
        <translation>Paramètres du modèle de propagation, p. ex. p0=0.5</translation>
    </message>
    <message>
        <source>Parameter of the spread model, e.g. p0=0.5; several are separated by ;.</source>
        <translation>Paramètre du modèle de propagation, p. ex. p0=0.5 ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>File with the probabilities for other tools (.mtx, .npz)</source>
        <translation>Fichier avec les probabilités pour d'autres logiciels (.mtx, .npz)</translation>
    </message>
    <message>
        <source>Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or .graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.</source>
        <translation>Écrit aussi les probabilités pour d'autres logiciels : .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) ou .graphml (jusqu'à 20,000 cellules avec combustible). Les cellules sont numérotées ligne par ligne depuis le haut à gauche.</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; with 8 by 0.002 and 3.4 %. Every command reads such files.</source>
        <translation>Bits par nombre dans le fichier. Avec 16, les probabilités sont fausses de 8e-6 au plus, les temps et la chaleur de 0.013 % ; avec 8, de 0.002 et 3.4 %. Toutes les commandes lisent ces fichiers.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exact</translation>
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
        <translation>Où une ligne peut être tenue</translation>
    </message>
    <message>
        <source>Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by it.</source>
        <translation>Note de 0 à 1 si une ligne peut être tenue dans chaque cellule : ce que vaut la meilleure ligne à portée (crêtes, fonds de vallée, routes, rivières, bords du combustible), avec la pente pour les engins et l'accès. Les plans la suivent.</translation>
    </message>
    <message>
        <source>The weights have no source for your region: they are yours to set.</source>
        <translation>Les poids n'ont pas de source pour votre région : à vous de les fixer.</translation>
    </message>
    <message>
        <source>Mean suitability where there is fuel</source>
        <translation>Aptitude moyenne où il y a du combustible</translation>
    </message>
    <message>
        <source>Roads and tracks</source>
        <translation>Routes et pistes</translation>
    </message>
    <message>
        <source>Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which crews drive; those that stop fire are barriers too.</source>
        <translation>Routes et pistes (lignes ou raster), le long desquelles les coupures sont plus faciles à ouvrir et à tenir, et que prennent les équipes ; celles qui arrêtent le feu sont aussi des barrières.</translation>
    </message>
    <message>
        <source>Rivers and lakes</source>
        <translation>Rivières et lacs</translation>
    </message>
    <message>
        <source>Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are barriers too.</source>
        <translation>Rivières et lacs (lignes, surfaces, raster), le long desquels les coupures sont plus faciles à tenir ; ceux qui arrêtent le feu sont aussi des barrières.</translation>
    </message>
    <message>
        <source>What lines of the ground are worth, such as ridge=0.8; reach=60</source>
        <translation>Ce que valent les lignes du terrain, p. ex. ridge=0.8; reach=60</translation>
    </message>
    <message>
        <source>What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; several are separated by ;.</source>
        <translation>Ce que vaut une ligne, ou une portée, p. ex. ridge=0.8, valley=0 ou reach=60 ; plusieurs sont séparés par ;.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines</source>
        <translation>Compartiments bordés de lignes de contrôle</translation>
    </message>
    <message>
        <source>Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: potential operational delineations (PODs), on which crews agree before a fire.</source>
        <translation>Diviser le paysage en compartiments de taille semblable, bordés par les lignes les plus faciles à tenir : délimitations opérationnelles potentielles (PODs), dont les équipes conviennent avant un feu.</translation>
    </message>
    <message>
        <source>Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. The second layer of the file holds the borders.</source>
        <translation>Chaque compartiment a son combustible, ses départs de feu et ses enjeux, ce qui brûle dans des feux simulés et la qualité de sa limite. La seconde couche du fichier contient les limites.</translation>
    </message>
    <message>
        <source>Compartments</source>
        <translation>Compartiments</translation>
    </message>
    <message>
        <source>Borders in kilometres</source>
        <translation>Limites en kilomètres</translation>
    </message>
    <message>
        <source>Mean suitability of the borders</source>
        <translation>Aptitude moyenne des limites</translation>
    </message>
    <message>
        <source>Size of the compartments, such as 500ha</source>
        <translation>Taille des compartiments, p. ex. 500ha</translation>
    </message>
    <message>
        <source>Size of the compartments, hectares of fuel; none is larger than one and a half times this.</source>
        <translation>Taille des compartiments, en hectares de combustible ; aucun ne dépasse une fois et demie cette valeur.</translation>
    </message>
    <message>
        <source>Values at risk</source>
        <translation>Enjeux exposés</translation>
    </message>
    <message>
        <source>Values at risk: a raster, or polygons or points with "Field with the value" [default: 1 on fuel].</source>
        <translation>Enjeux exposés : un raster, ou des polygones ou points avec "Champ avec la valeur" [sinon 1 sur le combustible].</translation>
    </message>
    <message>
        <source>How long fires burn, such as 8h</source>
        <translation>Combien de temps les feux brûlent, p. ex. 8h</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: lognormal:8h,0.7, an assumption].</source>
        <translation>Combien de temps les feux brûlent : 8h, une liste que les passages prennent tour à tour (4h,8h), lognormal:8h,0.7 (médiane et sigma), uniform:2h,12h, ou weather [sinon lognormal:8h,0.7, une hypothèse].</translation>
    </message>
    <message>
        <source>Ignition points</source>
        <translation>Points d'éclosion</translation>
    </message>
    <message>
        <source>Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of ignition probability [default: one random cell with fuel a run].</source>
        <translation>Points, polygones (périmètres qui brûlent déjà ; tout fichier vecteur, ou CSV avec x et y) ou un raster de la probabilité d'éclosion [sinon une cellule au hasard avec combustible par passage].</translation>
    </message>
    <message>
        <source>Number of fires</source>
        <translation>Nombre de feux</translation>
    </message>
    <message>
        <source>Simulated fires.</source>
        <translation>Feux simulés.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine aléatoire</translation>
    </message>
    <message>
        <source>Seed of all draws.</source>
        <translation>Graine de tous les tirages.</translation>
    </message>
    <message>
        <source>How much more the worst ground counts than the best</source>
        <translation>Combien le pire terrain compte de plus que le meilleur</translation>
    </message>
    <message>
        <source>Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.</source>
        <translation>Nombre de fois que le pire terrain compte autant que le meilleur, de 1 à 100 ; 1 demande les limites les plus courtes.</translation>
    </message>
    <message>
        <source>Field with the value</source>
        <translation>Champ avec la valeur</translation>
    </message>
    <message>
        <source>Column of the value polygons or points [default: 1 for each].</source>
        <translation>Colonne des polygones ou points de valeur [sinon 1 pour chacun].</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Les valeurs sont</translation>
    </message>
    <message>
        <source>What the numbers of "Values at risk" are: so much in each cell of the raster, polygon or point (people), the sum of which is kept; or so much a hectare.</source>
        <translation>Ce que sont les nombres de "Enjeux exposés" : tant dans chaque cellule du raster, polygone ou point (personnes), dont la somme est gardée ; ou tant par hectare.</translation>
    </message>
    <message>
        <source>So much in each cell, polygon or point</source>
        <translation>Tant par cellule, polygone ou point</translation>
    </message>
    <message>
        <source>So much a hectare</source>
        <translation>Tant par hectare</translation>
    </message>
    <message>
        <source>Several values at risk, such as people=villages.gpkg,weight=2</source>
        <translation>Plusieurs enjeux exposés, p. ex. people=villages.gpkg,weight=2</translation>
    </message>
    <message>
        <source>Several values at risk, each as a name and a file, with its field, a weight (what a unit counts in the sum that is planned for) and as=density after it as needed; several are separated by ;, each is told by name.</source>
        <translation>Plusieurs enjeux, chacun comme nom et fichier, suivi au besoin de son champ, d'un poids (ce que compte une unité dans la somme pour laquelle on planifie) et de as=density ; plusieurs se séparent par ;, chacun est donné par son nom.</translation>
    </message>
    <message>
        <source>Conditions on features, such as barriers=highway = 'primary'</source>
        <translation>Conditions sur les entités, p. ex. barriers=highway = 'primary'</translation>
    </message>
    <message>
        <source>Take only features that fit a condition, with the name of the layer before it, such as barriers=highway = 'primary'; several are separated by ;.</source>
        <translation>Ne prend que les entités qui remplissent une condition, le nom de la couche devant, p. ex. barriers=highway = 'primary' ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>Use of the ignition points</source>
        <translation>Emploi des points d'éclosion</translation>
    </message>
    <message>
        <source>With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or start where such fires of the past are dense.</source>
        <translation>Avec des points ou polygones : les passages les prennent tour à tour (la graine tire l'ordre), partent de tous, ou partent où de tels feux du passé sont denses.</translation>
    </message>
    <message>
        <source>One for each fire, in turn</source>
        <translation>Un par feu, tour à tour</translation>
    </message>
    <message>
        <source>All at once in every fire</source>
        <translation>Tous à la fois dans chaque feu</translation>
    </message>
    <message>
        <source>More fires where they are dense</source>
        <translation>Plus de feux où ils sont denses</translation>
    </message>
    <message>
        <source>Ignition points without fuel</source>
        <translation>Points d'éclosion sans combustible</translation>
    </message>
    <message>
        <source>What to do with points and polygons off the landscape or without fuel.</source>
        <translation>Que faire des points et polygones hors du paysage ou sans combustible.</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Les laisser de côté</translation>
    </message>
    <message>
        <source>Column with the hour of each ignition</source>
        <translation>Colonne avec l'heure de chaque éclosion</translation>
    </message>
    <message>
        <source>Column of the ignitions that tells when each is lit, in hours after the start of the run.</source>
        <translation>Colonne des éclosions qui dit quand chacune s'allume, en heures après le début du passage.</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Brandons</translation>
    </message>
    <message>
        <source>Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.</source>
        <translation>Brandons qui volent devant le feu : on, ou des nombres comme rate=12,longest=1000 à la place de ceux supposés.</translation>
    </message>
    <message>
        <source>When crews contain a fire, such as 6h</source>
        <translation>Quand les secours contiennent un feu, p. ex. 6h</translation>
    </message>
    <message>
        <source>When crews contain each fire: a time or a distribution as for "How long fires burn", or a direct attack at such a time, which fails if the fire is too large or too fierce by then: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].</source>
        <translation>Quand les secours contiennent chaque feu : un temps ou une distribution comme pour "Combien de temps les feux brûlent", ou une attaque directe à ce moment, qui échoue si le feu est alors trop grand ou trop intense : attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha au-dessus) [sinon jamais].</translation>
    </message>
    <message>
        <source>How often a break holds, such as 0.47</source>
        <translation>Combien de fois un pare-feu tient, p. ex. 0.47</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: 0.47, an assumption].</source>
        <translation>Combien de fois un morceau de pare-feu tient dans un passage : une part (0.47 sur le terrain), flame (selon la largeur et l'intensité du feu, Wilson 1988) ou flame:flames (1.5 longueurs de flamme) ; les morceaux ont 400 m, ou comme dans 0.47:800 [sinon 0.47, une hypothèse].</translation>
    </message>
    <message>
        <source>How often a barrier holds, such as 0.9</source>
        <translation>Combien de fois une barrière tient, p. ex. 0.9</translation>
    </message>
    <message>
        <source>Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.</source>
        <translation>Part des passages où un morceau des barrières tient ; tirée à part des pare-feu.</translation>
    </message>
    <message>
        <source>Stations of crews whom breaks wait for</source>
        <translation>Bases des secours que les pare-feu attendent</translation>
    </message>
    <message>
        <source>Points or areas that crews set out from: a stretch of break holds only against fire that comes after them [default: crews are everywhere].</source>
        <translation>Points ou zones d'où partent les secours : un morceau de pare-feu ne tient que contre le feu qui arrive après eux [sinon les secours sont partout].</translation>
    </message>
    <message>
        <source>Travel of crews, such as road=40,off=3,delay=10</source>
        <translation>Trajet des secours, p. ex. road=40,off=3,delay=10</translation>
    </message>
    <message>
        <source>How they travel: speed on roads and off them in km/h, and minutes from the start of the fire until they leave [default: road=40,off=3,delay=10, assumptions].</source>
        <translation>Comment ils se déplacent : vitesse sur route et hors route en km/h, et minutes du début du feu à leur départ [sinon road=40,off=3,delay=10, des hypothèses].</translation>
    </message>
    <message>
        <source>Fires without an end by time</source>
        <translation>Feux sans fin par la durée</translation>
    </message>
    <message>
        <source>Fires end by themselves and breaks hold in every fire unless "How often a break holds" says otherwise, as in the paper.</source>
        <translation>Les feux finissent d'eux-mêmes et les pare-feu tiennent dans chaque feu, si "Combien de fois un pare-feu tient" ne dit rien d'autre, comme dans l'article.</translation>
    </message>
    <message>
        <source>Table of weather</source>
        <translation>Tableau météo</translation>
    </message>
    <message>
        <source>Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2.</source>
        <translation>Ensemble de situations météo, dont chaque passage tire une : un fichier CSV avec wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time ; ou une rose des vents comme rose:NW=5x0.4,N=8x0.2.</translation>
    </message>
    <message>
        <source>as a wind rose: rose:NW=5x0.4,N=8x0.2</source>
        <translation>comme rose des vents : rose:NW=5x0.4,N=8x0.2</translation>
    </message>
    <message>
        <source>Time of each line of the table of weather, such as 1h</source>
        <translation>Durée de chaque ligne du tableau météo, p. ex. 1h</translation>
    </message>
    <message>
        <source>The lines of the weather follow each other, and each lasts so long, e.g. 1h.</source>
        <translation>Les lignes de la météo se suivent, et chacune dure autant, p. ex. 1h.</translation>
    </message>
    <message>
        <source>Columns of the table of weather, such as wind_speed=FF</source>
        <translation>Colonnes du tableau météo, p. ex. wind_speed=FF</translation>
    </message>
    <message>
        <source>Name of a column of the weather, e.g. wind_speed=FF; several are separated by ;.</source>
        <translation>Nom d'une colonne de la météo, p. ex. wind_speed=FF ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>Units of the table of weather, such as wind_speed=kn</source>
        <translation>Unités du tableau météo, p. ex. wind_speed=kn</translation>
    </message>
    <message>
        <source>Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; several are separated by ;.</source>
        <translation>Unité d'une colonne de la météo qui ne la dit pas, p. ex. wind_speed=kn ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>Columns of the table of weather to leave out</source>
        <translation>Colonnes du tableau météo à laisser de côté</translation>
    </message>
    <message>
        <source>Columns of the weather to leave out, separated by commas.</source>
        <translation>Colonnes de la météo à laisser de côté, séparées par des virgules.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, and their borders</source>
        <translation>Compartiments bordés de lignes de contrôle, et leurs limites</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, without outlines</source>
        <translation>Compartiments bordés de lignes de contrôle, sans contours</translation>
    </message>
    <message>
        <source>Borders of the compartments, without lines</source>
        <translation>Limites des compartiments, sans lignes</translation>
    </message>
    <message>
        <source>Plan fire breaks</source>
        <translation>Planifier des pare-feu</translation>
    </message>
    <message>
        <source>Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and with the breaks.</source>
        <translation>Planifie des pare-feu à partir de couches : où couper, que construire d'abord, et combien de fois chaque cellule brûle sans et avec les pare-feu.</translation>
    </message>
    <message>
        <source>Cells cut</source>
        <translation>Cellules coupées</translation>
    </message>
    <message>
        <source>Area cut in hectares</source>
        <translation>Surface coupée en hectares</translation>
    </message>
    <message>
        <source>Mean burnt share without breaks</source>
        <translation>Part brûlée moyenne sans pare-feu</translation>
    </message>
    <message>
        <source>Mean burnt share with the breaks</source>
        <translation>Part brûlée moyenne avec les pare-feu</translation>
    </message>
    <message>
        <source>Area where nothing may be cut</source>
        <translation>Zone où rien ne peut être coupé</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.</source>
        <translation>Zone (raster ou polygones ; les lignes prennent les cellules qu'elles touchent) où rien ne peut être coupé.</translation>
    </message>
    <message>
        <source>Existing barriers</source>
        <translation>Barrières existantes</translation>
    </message>
    <message>
        <source>Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and cost nothing.</source>
        <translation>Pare-feu, routes, rivières existants (raster, lignes ou polygones) : toutes les cellules qu'ils coupent n'ont pas de combustible et ne coûtent rien.</translation>
    </message>
    <message>
        <source>Budget, such as 10%, 5ha or 20000eur</source>
        <translation>Budget, p. ex. 10%, 5ha ou 20000eur</translation>
    </message>
    <message>
        <source>How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or money such as 20000eur, in the currency of the costs.</source>
        <translation>Combien couper : une part des cellules avec combustible comme 10% ou 0.1, une surface comme 5ha, ou de l'argent comme 20000eur, dans la monnaie des coûts.</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Méthode de classement</translation>
    </message>
    <message>
        <source>By which cells are ranked; higher is cut earlier. All are described below.</source>
        <translation>D'après quoi les cellules sont classées ; plus haut est coupé plus tôt. Toutes sont décrites plus bas.</translation>
    </message>
    <message>
        <source>Betweenness centrality: cells that lie on many fastest routes of fire</source>
        <translation>Centralité d'intermédiarité : cellules situées sur beaucoup des trajets les plus rapides du feu</translation>
    </message>
    <message>
        <source>Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves</source>
        <translation>Centralité de Bonacich : cellules par lesquelles le feu atteint des cellules elles-mêmes faciles à atteindre</translation>
    </message>
    <message>
        <source>Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere</source>
        <translation>Centralité de proximité : cellules que le feu atteint tôt de partout, ou d'où il atteint tôt partout</translation>
    </message>
    <message>
        <source>Compartments: a square grid of bands that encloses equal ones</source>
        <translation>Compartiments : un quadrillage de bandes qui enferme des compartiments égaux</translation>
    </message>
    <message>
        <source>Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone</source>
        <translation>Intermédiarité de courant : cellules par où passe la propagation par n'importe quel trajet, pas seulement le plus rapide</translation>
    </message>
    <message>
        <source>Degree: cells that are lit by, or light, their neighbours most</source>
        <translation>Degré : cellules que leurs voisines enflamment le plus, ou qui les enflamment le plus</translation>
    </message>
    <message>
        <source>Defensible fuel profile zones (DFPZ): broad bands along roads and ridges</source>
        <translation>Zones de combustible défendables (DFPZ) : larges bandes le long des routes et des crêtes</translation>
    </message>
    <message>
        <source>Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first</source>
        <translation>Dissection : murs entre compartiments par coupes minimales emboîtées, d'abord ceux qui épargnent le plus pour leur coût</translation>
    </message>
    <message>
        <source>Dominator: exact gain of cutting one cell, found anew after every few cuts</source>
        <translation>Dominateur : gain exact de la coupe d'une cellule, recalculé toutes les quelques coupes</translation>
    </message>
    <message>
        <source>DomiRank: cells that dominate their neighbourhood when neighbours compete</source>
        <translation>DomiRank : cellules qui dominent leur voisinage quand les voisines rivalisent</translation>
    </message>
    <message>
        <source>Downstream protection value: cells from which most value was lit, found anew after every few cuts</source>
        <translation>Valeur de protection en aval : cellules d'où le plus de valeur a été enflammée, recalculée toutes les quelques coupes</translation>
    </message>
    <message>
        <source>Eigenvector centrality: cells next to the cells that matter most, all in one place of the map</source>
        <translation>Centralité de vecteur propre : cellules à côté des cellules qui comptent le plus, toutes en un endroit de la carte</translation>
    </message>
    <message>
        <source>Flammability: most flammable cells first, the conventional policy, which looks at each cell alone</source>
        <translation>Inflammabilité : les cellules les plus inflammables d'abord, la pratique usuelle, qui regarde chaque cellule à part</translation>
    </message>
    <message>
        <source>Group betweenness: built cell by cell, each covers fastest routes that the group leaves open</source>
        <translation>Intermédiarité de groupe : formé cellule par cellule, chacune couvre des trajets plus rapides que le groupe laisse ouverts</translation>
    </message>
    <message>
        <source>Influence: cells by way of which fires with a clock take most, found anew after every few cuts on the same draws</source>
        <translation>Influence : cellules par lesquelles les feux avec horloge brûlent le plus, recherchées à nouveau toutes les quelques coupes avec les mêmes tirages</translation>
    </message>
    <message>
        <source>Information centrality: cells that many parallel ways of spread join closely to all others</source>
        <translation>Centralité d'information : cellules que beaucoup de voies parallèles de propagation relient étroitement à toutes les autres</translation>
    </message>
    <message>
        <source>PageRank: cells that a fire wandering at random from cell to cell is often in</source>
        <translation>PageRank : cellules où se trouve souvent un feu qui erre au hasard de cellule en cellule</translation>
    </message>
    <message>
        <source>Percolation centrality: cells on many fastest routes from where fires start</source>
        <translation>Centralité de percolation : cellules sur beaucoup des trajets les plus rapides depuis les lieux d'éclosion</translation>
    </message>
    <message>
        <source>Random: cells in random order, the baseline that every plan must beat</source>
        <translation>Hasard : cellules en ordre aléatoire, la référence que tout plan doit battre</translation>
    </message>
    <message>
        <source>Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them</source>
        <translation>Zones de traitement placées stratégiquement (SPLAT) : taches décalées qui ralentissent le feu, sans passage droit</translation>
    </message>
    <message>
        <source>Stripes: parallel bands across a direction, the plainest pattern of practice</source>
        <translation>Bandes : bandes parallèles en travers d'une direction, le motif le plus simple de la pratique</translation>
    </message>
    <message>
        <source>Unit of a budget that is a plain number</source>
        <translation>Unité d'un budget qui est un simple nombre</translation>
    </message>
    <message>
        <source>What a plain number for "Budget" counts: a share of the fuel, hectares, or money [default: share].</source>
        <translation>Ce que compte un simple nombre dans "Budget" : une part du combustible, des hectares, ou de l'argent [sinon une part].</translation>
    </message>
    <message>
        <source>Share of the fuel (0 to 1)</source>
        <translation>Part du combustible (0 à 1)</translation>
    </message>
    <message>
        <source>Hectares</source>
        <translation>Hectares</translation>
    </message>
    <message>
        <source>Money</source>
        <translation>Argent</translation>
    </message>
    <message>
        <source>Parameters of the ranking, such as beta=0.5; width=60</source>
        <translation>Paramètres de la méthode de classement, p. ex. beta=0.5; width=60</translation>
    </message>
    <message>
        <source>Parameter of the ranking, e.g. beta=0.5; several are separated by ;.</source>
        <translation>Paramètre de la méthode de classement, p. ex. beta=0.5 ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>Share of the spread that a break lets through</source>
        <translation>Part de la propagation qu'un pare-feu laisse passer</translation>
    </message>
    <message>
        <source>Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.</source>
        <translation>Part de sa probabilité de propagation que garde une cellule traitée ; 0 est un pare-feu parfait, les vrais laissent passer.</translation>
    </message>
    <message>
        <source>Least width of the breaks [m]</source>
        <translation>Largeur minimale des pare-feu [m]</translation>
    </message>
    <message>
        <source>Least width of the breaks, rounded up to whole cells [default: one cell, or the best for "Share of the spread that a break lets through"].</source>
        <translation>Largeur minimale des pare-feu, arrondie à des cellules entières [sinon une cellule, ou la meilleure pour "Part de la propagation qu'un pare-feu laisse passer"].</translation>
    </message>
    <message>
        <source>Improve the breaks on simulated fires (takes longer)</source>
        <translation>Améliorer les pare-feu sur des feux simulés (plus long)</translation>
    </message>
    <message>
        <source>Improve the breaks by local search on simulated fires; takes longer.</source>
        <translation>Améliore les pare-feu par recherche locale sur des feux simulés ; plus long.</translation>
    </message>
    <message>
        <source>Fires that the plan is made for</source>
        <translation>Feux pour lesquels le plan est fait</translation>
    </message>
    <message>
        <source>What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).</source>
        <translation>Ce qui doit être petit : la perte du feu moyen, ou celle du pire dixième des feux (CVaR).</translation>
    </message>
    <message>
        <source>The mean fire</source>
        <translation>Le feu moyen</translation>
    </message>
    <message>
        <source>The worst tenth of the fires</source>
        <translation>Le pire dixième des feux</translation>
    </message>
    <message>
        <source>Width of breaks that are lines [m]</source>
        <translation>Largeur des pare-feu qui sont des lignes [m]</translation>
    </message>
    <message>
        <source>Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length times their width. With "How often a break holds" flame, auto is the width with which fires take least. cells cuts whole cells, as in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.</source>
        <translation>Largeur des lignes que sont les pare-feu, p. ex. 12m, même moindre qu'une cellule ; le budget compte leur longueur fois leur largeur. Avec "Combien de fois un pare-feu tient" flame, auto est la largeur avec laquelle les feux prennent le moins. cells coupe des cellules entières, comme dans l'article. Par défaut : des lignes larges d'une cellule, 30 m au plus, là où les feux ont une horloge et où les pare-feu ne fuient pas.</translation>
    </message>
    <message>
        <source>Treatments (CSV, or default)</source>
        <translation>Traitements (CSV, ou default)</translation>
    </message>
    <message>
        <source>Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires burn with what they leave [default: all segments alike, by "Share of the spread that a break lets through"].</source>
        <translation>Tableau des traitements (CSV : name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), ou default : chaque tronçon reçoit celui qui épargne le plus pour son coût, un budget en argent est ce qu'ils coûtent, et les feux brûlent avec ce qu'ils laissent [sinon tous les tronçons pareils, selon "Part de la propagation qu'un pare-feu laisse passer"].</translation>
    </message>
    <message>
        <source>as a word</source>
        <translation>comme mot</translation>
    </message>
    <message>
        <source>Breaks that stand already</source>
        <translation>Pare-feu qui existent déjà</translation>
    </message>
    <message>
        <source>Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.</source>
        <translation>Pare-feu qui existent déjà (lignes, polygones, ou un raster dont chaque morceau connexe en est un) : les feux les rencontrent avec et sans le plan, ils cèdent comme les nouveaux, et leur combustible repousse s'ils ne sont pas entretenus.</translation>
    </message>
    <message>
        <source>as polygons or lines</source>
        <translation>comme polygones ou lignes</translation>
    </message>
    <message>
        <source>Years of building and upkeep</source>
        <translation>Années de construction et d'entretien</translation>
    </message>
    <message>
        <source>Number of years over which the breaks are built and kept up; 1: all is built at once.</source>
        <translation>Nombre d'années sur lesquelles les pare-feu sont construits et entretenus ; 1 : tout est construit d'un coup.</translation>
    </message>
    <message>
        <source>Budget of each year, such as 500ha</source>
        <translation>Budget de chaque année, p. ex. 500ha</translation>
    </message>
    <message>
        <source>What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share [default: what all breaks cost, over the years].</source>
        <translation>Ce que chaque année permet pour l'entretien, payé d'abord, et la construction : 500ha, 20000eur ou une part [sinon ce que coûtent tous les pare-feu, réparti sur les années].</translation>
    </message>
    <message>
        <source>Fires that start in a year</source>
        <translation>Feux qui éclosent en une année</translation>
    </message>
    <message>
        <source>Number of fires that start in a year.</source>
        <translation>Nombre de feux qui éclosent en une année.</translation>
    </message>
    <message>
        <source>Discount rate a year, such as 3%</source>
        <translation>Taux d'actualisation par an, p. ex. 3%</translation>
    </message>
    <message>
        <source>Rate a year, such as 3%, at which later costs and losses count less.</source>
        <translation>Taux par an, p. ex. 3%, auquel les coûts et pertes ultérieurs comptent moins.</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back</source>
        <translation>Années jusqu'à ce que le combustible traité ait repoussé</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "Treatments", or agricultural=3,shrubs=4,pines=4, an assumption].</source>
        <translation>Années jusqu'à ce que le combustible traité ait repoussé : 4, ou agricultural=3,shrubs=4,pines=8 [sinon celles de "Traitements", ou agricultural=3,shrubs=4,pines=4, une hypothèse].</translation>
    </message>
    <message>
        <source>Cost of treating anew, as a share of treating first</source>
        <translation>Coût d'un nouveau traitement, en part du premier</translation>
    </message>
    <message>
        <source>What treating anew costs, as a share of treating first.</source>
        <translation>Ce que coûte un nouveau traitement, en part du premier.</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare</source>
        <translation>Coût de coupe par hectare</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost", or classes such as agricultural=500,shrubs=900,pines=1500.</source>
        <translation>Coût de coupe par hectare : un raster, des polygones avec "Champ avec le coût", ou des classes comme agricultural=500,shrubs=900,pines=1500.</translation>
    </message>
    <message>
        <source>as classes: agricultural=500,pines=1500</source>
        <translation>comme classes : agricultural=500,pines=1500</translation>
    </message>
    <message>
        <source>Field with the cost</source>
        <translation>Champ avec le coût</translation>
    </message>
    <message>
        <source>Column of the cost polygons.</source>
        <translation>Colonne des polygones de coût.</translation>
    </message>
    <message>
        <source>Cost per hectare where none is known</source>
        <translation>Coût par hectare où aucun n'est connu</translation>
    </message>
    <message>
        <source>Cost per hectare where "Cost of cutting per hectare" tells none; alone, everywhere [default: nothing is cut there].</source>
        <translation>Coût par hectare où "Coût de coupe par hectare" n'en dit aucun ; seul, partout [sinon rien n'y est coupé].</translation>
    </message>
    <message>
        <source>Area outside of which nothing may be cut</source>
        <translation>Zone hors de laquelle rien ne peut être coupé</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.</source>
        <translation>Zone (raster ou polygones ; les lignes prennent les cellules qu'elles touchent) hors de laquelle rien ne peut être coupé.</translation>
    </message>
    <message>
        <source>Cells that protected and allowed areas keep</source>
        <translation>Cellules que les zones protégées et permises gardent</translation>
    </message>
    <message>
        <source>Cells that "Area where nothing may be cut" and "Area outside of which nothing may be cut" keep from being cut: all with a part inside the one or outside the other, or those whose centre is.</source>
        <translation>Cellules que "Zone où rien ne peut être coupé" et "Zone hors de laquelle rien ne peut être coupé" gardent de la coupe : toutes celles dont une partie est dans l'une ou hors de l'autre, ou celles dont le centre l'est.</translation>
    </message>
    <message>
        <source>Cells with any part in the area</source>
        <translation>Cellules dont une partie est dans la zone</translation>
    </message>
    <message>
        <source>Cells whose centre is in the area</source>
        <translation>Cellules dont le centre est dans la zone</translation>
    </message>
    <message>
        <source>Area of interest that is planned for</source>
        <translation>Zone d'intérêt pour laquelle on planifie</translation>
    </message>
    <message>
        <source>Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start and burn there too.</source>
        <translation>Zone d'intérêt (raster ou polygones) pour laquelle on planifie : rien n'est coupé en dehors, mais des feux y partent et y brûlent aussi.</translation>
    </message>
    <message>
        <source>How much more a break counts in bad ground (0: all ground alike)</source>
        <translation>De combien une coupure compte plus en mauvais terrain (0 : tout égal)</translation>
    </message>
    <message>
        <source>How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].</source>
        <translation>De combien une coupure compte plus dans le pire terrain que sur une crête, une route, une rivière ou le bord du combustible ; 0 : tout terrain égal, comme dans l'article [par défaut : 1.5 où le terrain est connu et a du relief].</translation>
    </message>
    <message>
        <source>Steeper ground is not cut [degrees]</source>
        <translation>Le terrain plus raide n'est pas coupé [degrés]</translation>
    </message>
    <message>
        <source>Ground that is steeper is not cut.</source>
        <translation>Le terrain qui est plus raide n'est pas coupé.</translation>
    </message>
    <message>
        <source>Cut only within this distance of roads, such as 200m</source>
        <translation>Ne couper qu'à cette distance des routes, p. ex. 200m</translation>
    </message>
    <message>
        <source>Only ground within this of a road is cut: 200m.</source>
        <translation>Seul le terrain à cette distance d'une route est coupé : 200m.</translation>
    </message>
    <message>
        <source>Cut nothing within this distance of roads, such as 50m</source>
        <translation>Ne rien couper à cette distance des routes, p. ex. 50m</translation>
    </message>
    <message>
        <source>Ground within this of a road is not cut: 50m.</source>
        <translation>Le terrain à cette distance d'une route n'est pas coupé : 50m.</translation>
    </message>
    <message>
        <source>Fire breaks</source>
        <translation>Pare-feu</translation>
    </message>
    <message>
        <source>Fire breaks as polygons</source>
        <translation>Pare-feu comme polygones</translation>
    </message>
    <message>
        <source>Segments to build, in order</source>
        <translation>Tronçons à construire, dans l'ordre</translation>
    </message>
    <message>
        <source>Compartments between the breaks</source>
        <translation>Compartiments entre les pare-feu</translation>
    </message>
    <message>
        <source>The plan on one page: map, segments, doubt; opens in any browser</source>
        <translation>Le plan en une page : carte, tronçons, incertitude ; s'ouvre dans tout navigateur</translation>
    </message>
    <message>
        <source>Cutting priority</source>
        <translation>Priorité de coupe</translation>
    </message>
    <message>
        <source>What each cell would keep of its spread once treated</source>
        <translation>Ce que chaque cellule garderait de sa propagation une fois traitée</translation>
    </message>
    <message>
        <source>Burn frequency without breaks</source>
        <translation>Fréquence de brûlage sans pare-feu</translation>
    </message>
    <message>
        <source>Burn frequency with the breaks</source>
        <translation>Fréquence de brûlage avec les pare-feu</translation>
    </message>
    <message>
        <source>Existing breaks, what each is worth, and whether it is kept up</source>
        <translation>Pare-feu existants, ce que vaut chacun et s'il est entretenu</translation>
    </message>
    <message>
        <source>What the plan does for its goal and for all others</source>
        <translation>Ce que le plan fait pour son but et pour tous les autres</translation>
    </message>
    <message>
        <source>What is built, kept up and burnt in each year</source>
        <translation>Ce qui est construit, entretenu et brûlé chaque année</translation>
    </message>
    <message>
        <source>Size of every fire without and with the breaks</source>
        <translation>Taille de chaque feu sans et avec les pare-feu</translation>
    </message>
    <message>
        <source>Burnt share at every budget</source>
        <translation>Part brûlée à chaque budget</translation>
    </message>
    <message>
        <source>Cells burnt in every run of it</source>
        <translation>Cellules brûlées à chacun de ses passages</translation>
    </message>
    <message>
        <source>Burnt share at every budget, without a clock and with perfect breaks</source>
        <translation>Part brûlée à chaque budget, sans horloge et avec des pare-feu parfaits</translation>
    </message>
    <message>
        <source>Picture of the plan</source>
        <translation>Image du plan</translation>
    </message>
    <message>
        <source>Rank cells</source>
        <translation>Classer les cellules</translation>
    </message>
    <message>
        <source>Rank the cells of a spread network by the order in which they should be cut: higher is earlier.</source>
        <translation>Classe les cellules d'un réseau de propagation dans l'ordre où elles sont à couper : plus haut est plus tôt.</translation>
    </message>
    <message>
        <source>Rankings that lay a pattern for the budget give another order for another budget.</source>
        <translation>Les méthodes qui tracent un motif pour le budget donnent un autre ordre pour un autre budget.</translation>
    </message>
    <message>
        <source>Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.</source>
        <translation>Huit bandes avec la probabilité que le feu passe vers N, NE, E, SE, S, SO, O et NO.</translation>
    </message>
    <message>
        <source>Elevation, for methods that follow ridges [m].</source>
        <translation>Altitude, pour les méthodes qui suivent les crêtes [m].</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: alike].</source>
        <translation>Avec quelle probabilité un feu éclôt dans chaque cellule, par rapport aux autres [sinon pareil].</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost".</source>
        <translation>Coût de coupe par hectare : un raster, des polygones avec "Champ avec le coût".</translation>
    </message>
    <message>
        <source>Select fire breaks</source>
        <translation>Choisir les pare-feu</translation>
    </message>
    <message>
        <source>Cut the cells of highest priority, as many as the budget allows.</source>
        <translation>Coupe les cellules de plus haute priorité, autant que le budget le permet.</translation>
    </message>
    <message>
        <source>Ties are cut by row, then column. A priority that was made for another budget is warned of.</source>
        <translation>À égalité on coupe par ligne, puis par colonne. Une priorité faite pour un autre budget est signalée.</translation>
    </message>
    <message>
        <source>Score by which cells are cut, higher is earlier.</source>
        <translation>Score d'après lequel les cellules sont coupées, plus haut est plus tôt.</translation>
    </message>
    <message>
        <source>Cost per hectare, for budgets of money: a raster, or polygons with "Field with the cost".</source>
        <translation>Coût par hectare, pour des budgets en argent : un raster, ou des polygones avec "Champ avec le coût".</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority</source>
        <translation>Prendre un raster qui n'a pas été écrit comme priorité</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority all the same: its greatest numbers are cut first.</source>
        <translation>Prend quand même un raster qui n'a pas été écrit comme priorité : ses plus grands nombres sont coupés d'abord.</translation>
    </message>
    <message>
        <source>Segments to build</source>
        <translation>Tronçons à construire</translation>
    </message>
    <message>
        <source>Take fire breaks apart into segments to build, best first.</source>
        <translation>Décompose les pare-feu en tronçons à construire, les meilleurs d'abord.</translation>
    </message>
    <message>
        <source>Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope and cost, and the share of all that the breaks save that it adds.</source>
        <translation>Chaque tronçon sépare deux compartiments de combustible, et a un ordre de construction, une longueur, une largeur, une surface, une pente moyenne et un coût, et la part qu'il ajoute à tout ce que les pare-feu épargnent.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Tronçons</translation>
    </message>
    <message>
        <source>Stages of construction</source>
        <translation>Étapes de construction</translation>
    </message>
    <message>
        <source>Length in kilometres</source>
        <translation>Longueur en kilomètres</translation>
    </message>
    <message>
        <source>Cells that are cut: 1, all others 0.</source>
        <translation>Cellules coupées : 1, toutes les autres 0.</translation>
    </message>
    <message>
        <source>Ranking; decides between segments that save equally much.</source>
        <translation>Classement ; décide entre des tronçons qui épargnent autant.</translation>
    </message>
    <message>
        <source>Elevation on any grid, for the slopes [m].</source>
        <translation>Altitude sur toute grille, pour les pentes [m].</translation>
    </message>
    <message>
        <source>What of the segments goes into a format with one layer</source>
        <translation>Ce qui des tronçons va dans un format à une seule couche</translation>
    </message>
    <message>
        <source>Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].</source>
        <translation>Couche des tronçons à écrire : lignes médianes ou contours [sinon les deux en .gpkg, ailleurs les lignes].</translation>
    </message>
    <message>
        <source>Their middle lines</source>
        <translation>Leurs lignes médianes</translation>
    </message>
    <message>
        <source>Their outlines</source>
        <translation>Leurs contours</translation>
    </message>
    <message>
        <source>Map book for crews</source>
        <translation>Carnet de cartes pour les équipes</translation>
    </message>
    <message>
        <source>Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, its ends, sizes, slope, cost and treatment, and what it is for.</source>
        <translation>Imprime un plan en PDF : une vue d'ensemble, une liste des tronçons et une page pour chacun avec une carte à une échelle ronde, ses extrémités, ses dimensions, sa pente, son coût et son traitement, et à quoi il sert.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the plan were written. Its segments alone do as well, without the vegetation; then the elevation is asked for.</source>
        <translation>Choisissez le dossier dans lequel tous les fichiers du plan ont été écrits. Ses tronçons seuls suffisent aussi, sans la végétation ; l'altitude est alors demandée.</translation>
    </message>
    <message>
        <source>Segments with a page</source>
        <translation>Tronçons avec une page</translation>
    </message>
    <message>
        <source>Folder of the run</source>
        <translation>Dossier du passage</translation>
    </message>
    <message>
        <source>Into which a plan or a comparison was written with all its files.</source>
        <translation>Où un plan ou une comparaison a été écrit avec tous ses fichiers.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Title of the book [default: what the plan says of itself].</source>
        <translation>Titre du carnet [par défaut : ce que le plan dit de lui-même].</translation>
    </message>
    <message>
        <source>Date, as it is to be shown</source>
        <translation>Date, telle qu'elle doit paraître</translation>
    </message>
    <message>
        <source>Date of the data or the print, shown as it is given.</source>
        <translation>Date des données ou de l'impression, montrée telle qu'elle est donnée.</translation>
    </message>
    <message>
        <source>Roads to draw: lines or areas of any vector file.</source>
        <translation>Routes à dessiner : lignes ou surfaces de n'importe quel fichier vectoriel.</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw</source>
        <translation>Rivières et lacs à dessiner</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw: lines or areas.</source>
        <translation>Rivières et lacs à dessiner : lignes ou surfaces.</translation>
    </message>
    <message>
        <source>Most segments that get a page</source>
        <translation>Nombre maximal de tronçons avec une page</translation>
    </message>
    <message>
        <source>Segments that get a page, the first in order of construction; the list names all.</source>
        <translation>Tronçons qui reçoivent une page, les premiers dans l'ordre de construction ; la liste les nomme tous.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Size of the paper.</source>
        <translation>Format du papier.</translation>
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
        <translation>Lettre</translation>
    </message>
    <message>
        <source>as its segments (segments.gpkg)</source>
        <translation>comme ses tronçons (segments.gpkg)</translation>
    </message>
    <message>
        <source>Elevation on any grid, beside segments alone; the folder of a plan has its own.</source>
        <translation>Altitude sur n'importe quelle grille, si seuls des tronçons sont donnés ; le dossier d'un plan a la sienne.</translation>
    </message>
    <message>
        <source>Shorter segments get no page [m]</source>
        <translation>Les tronçons plus courts n'ont pas de page [m]</translation>
    </message>
    <message>
        <source>Segments shorter than this have no page of their own [m].</source>
        <translation>Les tronçons plus courts n'ont pas de page à eux [m].</translation>
    </message>
    <message>
        <source>Upright pages</source>
        <translation>Pages en hauteur</translation>
    </message>
    <message>
        <source>Upright pages, the texts under the map.</source>
        <translation>Pages en hauteur, les textes sous la carte.</translation>
    </message>
    <message>
        <source>Map book</source>
        <translation>Carnet de cartes</translation>
    </message>
    <message>
        <source>Files for crews</source>
        <translation>Fichiers pour les équipes</translation>
    </message>
    <message>
        <source>Write segments, breaks or compartments of a plan in the format of a crew.</source>
        <translation>Écrit les tronçons, les pare-feu ou les compartiments d'un plan dans le format d'une équipe.</translation>
    </message>
    <message>
        <source>The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, .zip for a Shapefile, .geojson for the web.</source>
        <translation>L'extension du fichier le choisit : .kml pour Google Earth et les téléphones, .gpx pour les appareils GPS, .dxf pour les dessins, .zip pour un Shapefile, .geojson pour le web.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Segments, breaks or compartments of a plan (.gpkg)</source>
        <translation>Tronçons, pare-feu ou compartiments d'un plan (.gpkg)</translation>
    </message>
    <message>
        <source>The segments.gpkg, breaks.gpkg or compartments.gpkg that a plan wrote.</source>
        <translation>Le segments.gpkg, breaks.gpkg ou compartments.gpkg qu'un plan a écrit.</translation>
    </message>
    <message>
        <source>File for the crew</source>
        <translation>Fichier pour l'équipe</translation>
    </message>
    <message>
        <source>Burn frequency</source>
        <translation>Fréquence de brûlage</translation>
    </message>
    <message>
        <source>Let many fires start and tell how often each cell burns.</source>
        <translation>Fait partir beaucoup de feux et dit combien de fois chaque cellule brûle.</translation>
    </message>
    <message>
        <source>Fires with a duration need a network with times. With the same seed the fires are the same with and without breaks, so their difference is the breaks' work alone.</source>
        <translation>Les feux avec une durée demandent un réseau avec des temps. Avec la même graine les feux sont les mêmes avec et sans pare-feu ; leur différence est donc l'œuvre des seuls pare-feu.</translation>
    </message>
    <message>
        <source>Mean burnt share</source>
        <translation>Part brûlée moyenne</translation>
    </message>
    <message>
        <source>Largest burnt share</source>
        <translation>Plus grande part brûlée</translation>
    </message>
    <message>
        <source>Mean fire in hectares</source>
        <translation>Feu moyen en hectares</translation>
    </message>
    <message>
        <source>Largest fire in hectares</source>
        <translation>Plus grand feu en hectares</translation>
    </message>
    <message>
        <source>Cut cells: a raster, or own breaks as polygons or lines.</source>
        <translation>Cellules coupées : un raster, ou des pare-feu à vous comme polygones ou lignes.</translation>
    </message>
    <message>
        <source>Roads, rivers and the like on ground that the network holds as fuel; they stop fire as "How often a barrier holds" says.</source>
        <translation>Routes, rivières et autres sur un sol que le réseau tient pour du combustible ; ils arrêtent le feu comme "Combien de fois une barrière tient" le dit.</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: until they end by themselves].</source>
        <translation>Combien de temps les feux brûlent : 8h, une liste que les passages prennent tour à tour (4h,8h), lognormal:8h,0.7 (médiane et sigma), uniform:2h,12h, ou weather [sinon jusqu'à ce qu'ils finissent d'eux-mêmes].</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: always].</source>
        <translation>Combien de fois un morceau de pare-feu tient dans un passage : une part (0.47 sur le terrain), flame (selon la largeur et l'intensité du feu, Wilson 1988) ou flame:flames (1.5 longueurs de flamme) ; les morceaux ont 400 m, ou comme dans 0.47:800 [sinon toujours].</translation>
    </message>
    <message>
        <source>Take "Fire breaks" as lines of this width, such as 12m, or of the width in that column; they may be narrower than a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].</source>
        <translation>Prend "Pare-feu" comme lignes de cette largeur, p. ex. 12m, ou de la largeur dans cette colonne ; elles peuvent être plus étroites qu'une cellule et arrêtent le feu entre les cellules qu'elles séparent [sinon les lignes prennent chaque cellule qu'elles touchent].</translation>
    </message>
    <message>
        <source>What treated cells keep of their spread (kept.tif)</source>
        <translation>Ce que les cellules traitées gardent de leur propagation (kept.tif)</translation>
    </message>
    <message>
        <source>What each cell keeps of its spread probability once it is treated, in place of one "Share of the spread that a break lets through" for all: kept.tif of a plan with treatments.</source>
        <translation>Ce que chaque cellule garde de sa probabilité de propagation une fois traitée, à la place d'une seule "Part de la propagation qu'un pare-feu laisse passer" pour toutes : kept.tif d'un plan avec traitements.</translation>
    </message>
    <message>
        <source>Side of the windows in which a large map is read [cells]</source>
        <translation>Côté des fenêtres dans lesquelles une grande carte est lue [cellules]</translation>
    </message>
    <message>
        <source>Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire needs it, so that maps larger than the memory can burn; the fires are the same.</source>
        <translation>Lit la carte par fenêtres de ce côté (une puissance de deux, p. ex. 512) autour de chaque feu, plus grandes où un feu le demande, pour que des cartes plus grandes que la mémoire puissent brûler ; les feux sont les mêmes.</translation>
    </message>
    <message>
        <source>Times for the folder of arrival times, such as 2h,4h</source>
        <translation>Temps pour le dossier des temps d'arrivée, p. ex. 2h,4h</translation>
    </message>
    <message>
        <source>Times for "Folder for arrival times".</source>
        <translation>Temps pour "Dossier pour temps d'arrivée".</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes [hectares]</source>
        <translation>Limites des classes de taille des feux [hectares]</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes for "Folder for arrival times", in hectares.</source>
        <translation>Limites des classes de taille des feux pour "Dossier pour temps d'arrivée", en hectares.</translation>
    </message>
    <message>
        <source>Flame lengths for the folder of arrival times [m]</source>
        <translation>Longueurs de flamme pour le dossier des temps d'arrivée [m]</translation>
    </message>
    <message>
        <source>Flame lengths for "Folder for arrival times", in metres; left out if the network knows no heat.</source>
        <translation>Longueurs de flamme pour "Dossier pour temps d'arrivée", en mètres ; omises si le réseau ne connaît pas la chaleur.</translation>
    </message>
    <message>
        <source>Fire sizes</source>
        <translation>Tailles des feux</translation>
    </message>
    <message>
        <source>Folder for arrival times, isochrones and more</source>
        <translation>Dossier pour temps d'arrivée, isochrones et autres</translation>
    </message>
    <message>
        <source>Judge existing breaks</source>
        <translation>Juger des pare-feu existants</translation>
    </message>
    <message>
        <source>Tell what each existing fire break is worth, and which gap between breaks matters most.</source>
        <translation>Dit ce que vaut chaque pare-feu existant, et quelle brèche entre pare-feu compte le plus.</translation>
    </message>
    <message>
        <source>The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are the work of that break alone. The same break at random places stands beside it. The network must hold the fuel that lies on the breaks.</source>
        <translation>Les mêmes feux brûlent avec tous les pare-feu, sans chacun d'eux et avec chaque brèche fermée ; les différences sont donc l'œuvre de ce seul pare-feu. À côté se tient le même pare-feu à des endroits au hasard. Le réseau doit contenir le combustible qui se trouve sur les pare-feu.</translation>
    </message>
    <message>
        <source>Longest gap that is looked at [m]</source>
        <translation>Plus longue brèche considérée [m]</translation>
    </message>
    <message>
        <source>Length of the longest gap that is looked at, in metres.</source>
        <translation>Longueur de la plus longue brèche considérée, en mètres.</translation>
    </message>
    <message>
        <source>Most gaps that are looked at</source>
        <translation>Nombre maximal de brèches considérées</translation>
    </message>
    <message>
        <source>Number of gaps looked at, the shortest.</source>
        <translation>Nombre de brèches considérées, les plus courtes.</translation>
    </message>
    <message>
        <source>Random places to compare each break with</source>
        <translation>Endroits au hasard auxquels comparer chaque pare-feu</translation>
    </message>
    <message>
        <source>Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.</source>
        <translation>Nombre d'endroits au hasard où chaque pare-feu et chaque brèche sont essayés aussi, pour comparer ; 0 les laisse de côté.</translation>
    </message>
    <message>
        <source>Breaks with what each is worth, and gaps with what closing them saves</source>
        <translation>Pare-feu avec ce que vaut chacun, et brèches avec ce qu'épargne leur fermeture</translation>
    </message>
    <message>
        <source>What each break is worth</source>
        <translation>Ce que vaut chaque pare-feu</translation>
    </message>
    <message>
        <source>What closing each gap saves</source>
        <translation>Ce qu'épargne la fermeture de chaque brèche</translation>
    </message>
    <message>
        <source>What stands and what is missing, in words</source>
        <translation>Ce qui tient et ce qui manque, en mots</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Évaluer</translation>
    </message>
    <message>
        <source>Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.</source>
        <translation>Juge les méthodes de classement : moyenne, centile 90 % et maximum de la part brûlée à chaque budget.</translation>
    </message>
    <message>
        <source>All rankings meet the same fires, and each plan is made for its budget.</source>
        <translation>Toutes les méthodes affrontent les mêmes feux, et chaque plan est fait pour son budget.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
    </message>
    <message>
        <source>Methods to hold against each other; all rankings are described below.</source>
        <translation>Méthodes à tenir l'une contre l'autre ; toutes celles de classement sont décrites plus bas.</translation>
    </message>
    <message>
        <source>Ranking to test against</source>
        <translation>Méthode contre laquelle on teste</translation>
    </message>
    <message>
        <source>Ranking that the others are tested against.</source>
        <translation>Méthode contre laquelle les autres sont testées.</translation>
    </message>
    <message>
        <source>Budgets, such as 5%, 10%</source>
        <translation>Budgets, p. ex. 5%, 10%</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: 0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</source>
        <translation>Combien couper, séparé par des virgules : parts du combustible comme 5% ou 0.05, ou surfaces comme 20ha [sinon de 0 à 0.4 par pas de 0.01 ; où chaque budget est brûlé à nouveau, avec une horloge ou des pare-feu qui cèdent, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test statistique</translation>
    </message>
    <message>
        <source>Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.</source>
        <translation>Rangs signés de Wilcoxon par paires, somme des rangs de Wilcoxon pour passages indépendants, ou t par paires.</translation>
    </message>
    <message>
        <source>Wilcoxon's signed-rank test of pairs</source>
        <translation>Test des rangs signés de Wilcoxon, par paires</translation>
    </message>
    <message>
        <source>Wilcoxon's rank-sum test of independent runs</source>
        <translation>Test de la somme des rangs de Wilcoxon, passages indépendants</translation>
    </message>
    <message>
        <source>Student's t-test of pairs</source>
        <translation>Test t de Student, par paires</translation>
    </message>
    <message>
        <source>Significance threshold</source>
        <translation>Seuil de signification</translation>
    </message>
    <message>
        <source>Significance threshold.</source>
        <translation>Seuil de signification.</translation>
    </message>
    <message>
        <source>Burnt share and significance of every ranking at every budget</source>
        <translation>Part brûlée et signification de chaque méthode à chaque budget</translation>
    </message>
    <message>
        <source>Cells burnt in every run, from which each p-value can be found again</source>
        <translation>Cellules brûlées à chaque passage, d'où chaque valeur p peut être retrouvée</translation>
    </message>
    <message>
        <source>Curves of the burnt share</source>
        <translation>Courbes de la part brûlée</translation>
    </message>
    <message>
        <source>Curves of the burnt share, to scale</source>
        <translation>Courbes de la part brûlée, vectorielles</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with intervals.</source>
        <translation>Compare des plans : surface brûlée attendue, valeur perdue, pires feux et hectares sauvés par hectare coupé, avec intervalles.</translation>
    </message>
    <message>
        <source>The fires are fresh: no plan was designed with them, and all burn in the same ones.</source>
        <translation>Les feux sont neufs : aucun plan n'a été conçu avec eux, et tous brûlent dans les mêmes.</translation>
    </message>
    <message>
        <source>Lines: walls as wide as a cell and at most 30 m, of which plans are made by default</source>
        <translation>Lignes : murs larges d'une cellule et de 30 m au plus, dont les plans sont faits par défaut</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.</source>
        <translation>Combien couper, séparé par des virgules : parts du combustible comme 5% ou 0.05, ou surfaces comme 20ha.</translation>
    </message>
    <message>
        <source>Shares that breaks let through, separated by commas</source>
        <translation>Parts que les pare-feu laissent passer, séparées par des virgules</translation>
    </message>
    <message>
        <source>Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.</source>
        <translation>Parts de sa probabilité de propagation que garde une cellule traitée, séparées par des virgules ; 0 est parfait.</translation>
    </message>
    <message>
        <source>Fires expected until the breaks have grown back</source>
        <translation>Feux attendus jusqu'à ce que les pare-feu aient repoussé</translation>
    </message>
    <message>
        <source>Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so often when it is held against what they cost.</source>
        <translation>Nombre de feux qui rencontrent les pare-feu avant qu'ils aient repoussé ; ce qu'ils épargnent dans un feu compte autant de fois quand on le tient contre ce qu'ils coûtent.</translation>
    </message>
    <message>
        <source>The comparison on one page; opens in any browser</source>
        <translation>La comparaison en une page ; s'ouvre dans tout navigateur</translation>
    </message>
    <message>
        <source>Every plan at every budget and leak, with intervals</source>
        <translation>Chaque plan à chaque budget et chaque fuite, avec intervalles</translation>
    </message>
    <message>
        <source>Curves of the plans</source>
        <translation>Courbes des plans</translation>
    </message>
    <message>
        <source>Curves of the plans, to scale</source>
        <translation>Courbes des plans, vectorielles</translation>
    </message>
    <message>
        <source>What each step of each plan costs and saves</source>
        <translation>Ce que chaque pas de chaque plan coûte et épargne</translation>
    </message>
    <message>
        <source>Saved against paid, and where the next hectare stops paying</source>
        <translation>L'épargné contre le payé, et où l'hectare suivant ne paie plus</translation>
    </message>
    <message>
        <source>Validate against a scar</source>
        <translation>Valider sur une zone brûlée</translation>
    </message>
    <message>
        <source>Hold a simulated fire against the area that burnt, beside fires that know nothing.</source>
        <translation>Tient un feu simulé contre la zone qui a brûlé, à côté de feux qui ne savent rien.</translation>
    </message>
    <message>
        <source>Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.</source>
        <translation>L'indice de Sørensen, l'IoU, l'IoU de la seule croissance, la taille, le score de Brier et la fiabilité sont donnés pour le feu simulé et pour les modèles nuls : aucune croissance, distance égale dans le combustible, une ellipse dans le vent.</translation>
    </message>
    <message>
        <source>Observed hectares</source>
        <translation>Hectares observés</translation>
    </message>
    <message>
        <source>Simulated hectares</source>
        <translation>Hectares simulés</translation>
    </message>
    <message>
        <source>Area that burnt</source>
        <translation>Zone brûlée</translation>
    </message>
    <message>
        <source>Perimeter of the fire as polygons, or a raster above 0 where it burnt.</source>
        <translation>Périmètre du feu comme polygones, ou un raster au-dessus de 0 où il a brûlé.</translation>
    </message>
    <message>
        <source>Where the fire was first seen</source>
        <translation>Où le feu a été vu d'abord</translation>
    </message>
    <message>
        <source>Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.</source>
        <translation>Où le feu a été vu d'abord : points, ou polygones qui brûlaient déjà (tout fichier vecteur), ou un raster.</translation>
    </message>
    <message>
        <source>How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.</source>
        <translation>Combien de temps le feu s'est propagé, p. ex. 3h ; lognormal:3h,0.5 (médiane, sigma) où ce n'est pas bien connu.</translation>
    </message>
    <message>
        <source>Number of simulated fires.</source>
        <translation>Nombre de feux simulés.</translation>
    </message>
    <message>
        <source>Scores of the simulated fire and of the null models</source>
        <translation>Scores du feu simulé et des modèles nuls</translation>
    </message>
    <message>
        <source>How often cells burnt, by the probability forecast</source>
        <translation>Combien de fois les cellules ont brûlé, selon la probabilité prévue</translation>
    </message>
    <message>
        <source>Share of the simulated fires in which each cell burns</source>
        <translation>Part des feux simulés où chaque cellule brûle</translation>
    </message>
    <message>
        <source>Picture of the simulated fire over the scar, with the reliability</source>
        <translation>Image du feu simulé sur la zone brûlée, avec la fiabilité</translation>
    </message>
    <message>
        <source>Calibrate on observed fires</source>
        <translation>Caler sur des feux observés</translation>
    </message>
    <message>
        <source>Fit the rate of spread, durations and spread probability to the fires of a region.</source>
        <translation>Ajuste la vitesse de propagation, les durées et la probabilité de propagation aux feux d'une région.</translation>
    </message>
    <message>
        <source>The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in which they burn. More numbers than the fires can tell are refused.</source>
        <translation>Les feux sont des polygones ou un tableau avec leurs tailles et, s'ils sont connus, leurs jours ; la météo dit les vents où ils brûlent. Ajuster plus de nombres que les feux n'en peuvent dire est refusé.</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Feux</translation>
    </message>
    <message>
        <source>Numbers fitted</source>
        <translation>Nombres ajustés</translation>
    </message>
    <message>
        <source>Observed fires with sizes and days</source>
        <translation>Feux observés avec tailles et jours</translation>
    </message>
    <message>
        <source>Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.</source>
        <translation>Polygones ou un tableau (CSV) des feux d'une région, avec leurs tailles en hectares et, s'ils sont connus, leurs jours.</translation>
    </message>
    <message>
        <source>What to fit: rate, duration, p0</source>
        <translation>Quoi ajuster : rate, duration, p0</translation>
    </message>
    <message>
        <source>What to fit: rate, duration and p0, separated by commas [default: rate and duration; of fewer than three scars the rate alone].</source>
        <translation>Quoi ajuster : rate, duration et p0, séparés par des virgules [sinon rate et duration ; avec moins de trois zones brûlées rate seul].</translation>
    </message>
    <message>
        <source>Smallest fire that counts [hectares]</source>
        <translation>Plus petit feu qui compte [hectares]</translation>
    </message>
    <message>
        <source>Fires of fewer hectares do not count: small ones are often not mapped.</source>
        <translation>Les feux de moins d'hectares ne comptent pas : les petits ne sont souvent pas cartographiés.</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: everywhere alike].</source>
        <translation>Avec quelle probabilité un feu éclôt dans chaque cellule, par rapport aux autres [sinon pareil partout].</translation>
    </message>
    <message>
        <source>Column with the size in hectares</source>
        <translation>Colonne avec la taille en hectares</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the size in hectares [default: found by name].</source>
        <translation>Colonne de "Feux observés avec tailles et jours" avec la taille en hectares [sinon trouvée par le nom].</translation>
    </message>
    <message>
        <source>Column with the first day</source>
        <translation>Colonne avec le premier jour</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the first day [default: found by name].</source>
        <translation>Colonne de "Feux observés avec tailles et jours" avec le premier jour [sinon trouvée par le nom].</translation>
    </message>
    <message>
        <source>Column with the last day</source>
        <translation>Colonne avec le dernier jour</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the last day [default: found by name].</source>
        <translation>Colonne de "Feux observés avec tailles et jours" avec le dernier jour [sinon trouvée par le nom].</translation>
    </message>
    <message>
        <source>Time of spread on each day of a fire [hours]</source>
        <translation>Temps de propagation chaque jour d'un feu [heures]</translation>
    </message>
    <message>
        <source>Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.</source>
        <translation>Heures pendant lesquelles un feu se propage chacun de ses jours ; une hypothèse qui distingue vitesses et durées.</translation>
    </message>
    <message>
        <source>Longest simulated fire, such as 200h</source>
        <translation>Plus long feu simulé, p. ex. 200h</translation>
    </message>
    <message>
        <source>No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].</source>
        <translation>Aucun feu ne se propage plus longtemps [sinon autant de jours entiers que le plus long feu observé, ou 200h].</translation>
    </message>
    <message>
        <source>Parameter of the spread model that stays as it is, e.g. moisture=0.06; several are separated by ;.</source>
        <translation>Paramètre du modèle de propagation qui reste tel quel, p. ex. moisture=0.06 ; plusieurs se séparent par ;.</translation>
    </message>
    <message>
        <source>Calibration, which other forms take</source>
        <translation>Calage, que prennent d'autres formulaires</translation>
    </message>
    <message>
        <source>What is told of each fire</source>
        <translation>Ce qui est dit de chaque feu</translation>
    </message>
    <message>
        <source>Report of a run</source>
        <translation>Rapport d'un passage</translation>
    </message>
    <message>
        <source>Show a plan or a comparison on one page: map, segments, curve, assumptions, files.</source>
        <translation>Montre un plan ou une comparaison en une page : carte, tronçons, courbe, hypothèses, fichiers.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the run were written. The page opens in any browser without a network. Its links lead to files beside the page, so write it into that folder.</source>
        <translation>Choisissez le dossier où tous les fichiers du passage ont été écrits. La page s'ouvre dans tout navigateur sans réseau. Ses liens mènent à des fichiers à côté de la page : écrivez-la donc dans ce dossier.</translation>
    </message>
    <message>
        <source>The run on one page</source>
        <translation>Le passage en une page</translation>
    </message>
    <message>
        <source>{} was not made: there is nothing to put in it.</source>
        <translation>{} n'a pas été fait : il n'y a rien à y mettre.</translation>
    </message>
    <message>
        <source>Stopped; no output was written.</source>
        <translation>Arrêté ; aucune sortie n'a été écrite.</translation>
    </message>
    <message>
        <source>Report: {} (open it from the Results Viewer)</source>
        <translation>Rapport : {} (à ouvrir dans la visionneuse de résultats)</translation>
    </message>
    <message>
        <source>[not chosen]</source>
        <translation>[non choisi]</translation>
    </message>
    <message>
        <source>{} holds {}; only a GeoPackage can hold {} as well.</source>
        <translation>{} contient {} ; seul un GeoPackage peut contenir aussi {}.</translation>
    </message>
    <message>
        <source>The layer {} cannot be read as cells of a raster.</source>
        <translation>La couche {} ne peut pas être lue comme cellules d'un raster.</translation>
    </message>
    <message>
        <source>An extent needs the CRS of the grid; choose it beside the extent (CRS).</source>
        <translation>Une emprise demande le SCR de la grille ; choisissez-le à côté de l'emprise (SCR).</translation>
    </message>
    <message>
        <source>Making the engine of Firebreak</source>
        <translation>Création du moteur de Firebreak</translation>
    </message>
    <message>
        <source>firebreak_gis {} is ready.</source>
        <translation>firebreak_gis {} est prêt.</translation>
    </message>
    <message>
        <source>firebreak_gis {} answers: {} ({})</source>
        <translation>firebreak_gis {} répond : {} ({})</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>Python with firebreak_gis, or the firebreak program</source>
        <translation>Python avec firebreak_gis, ou le programme firebreak</translation>
    </message>
    <message>
        <source>empty: found by itself</source>
        <translation>vide : trouvé tout seul</translation>
    </message>
    <message>
        <source>Python or program</source>
        <translation>Python ou programme</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Make an engine</source>
        <translation>Créer un moteur</translation>
    </message>
    <message>
        <source>Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The Python of QGIS is left alone, and an engine made before stays until the new one answers. Nothing is installed until you press the button.</source>
        <translation>Crée un environnement Python dans votre profil QGIS, environ 900 Mo, et y installe firebreak_gis : depuis l'index des paquets (par le proxy de QGIS), ou depuis le chemin d'un clone ou d'un wheel. Le Python de QGIS reste intact, et un moteur créé avant reste jusqu'à ce que le nouveau réponde. Rien n'est installé avant que vous n'appuyiez sur le bouton.</translation>
    </message>
    <message>
        <source>empty: the newest of 3.11 to 3.13 found</source>
        <translation>vide : le plus récent trouvé de 3.11 à 3.13</translation>
    </message>
    <message>
        <source>Python to make it from</source>
        <translation>Python dont il est fait</translation>
    </message>
    <message>
        <source>A name in the index, or the path of a clone or a wheel.</source>
        <translation>Un nom de l'index, ou le chemin d'un clone ou d'un wheel.</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Paquet</translation>
    </message>
    <message>
        <source>Make engine</source>
        <translation>Créer le moteur</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Firebreak settings…</source>
        <translation>Paramètres de Firebreak…</translation>
    </message>
    <message>
        <source>Firebreak</source>
        <translation>Firebreak</translation>
    </message>
    <message>
        <source>Firebreak (plan forest fire breaks)</source>
        <translation>Firebreak (planifier des pare-feu en forêt)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
</context>
</TS>
