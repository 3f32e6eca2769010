<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>Firebreak</name>
    <message>
        <source>1 Prepare</source>
        <translation>1 Preparare</translation>
    </message>
    <message>
        <source>2 Rank and cut</source>
        <translation>2 Ordinare e tagliare</translation>
    </message>
    <message>
        <source>3 Burn</source>
        <translation>3 Bruciare</translation>
    </message>
    <message>
        <source>4 Judge</source>
        <translation>4 Giudicare</translation>
    </message>
    <message>
        <source>Align landscape</source>
        <translation>Allineare il paesaggio</translation>
    </message>
    <message>
        <source>Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.</source>
        <translation>Porta quota, vegetazione e densità su una griglia quadrata comune in metri, con i codici tradotti in classi di combustibile.</translation>
    </message>
    <message>
        <source>The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape (.lcp) as elevation holds all layers.</source>
        <translation>I layer possono avere qualsiasi SR, estensione e dimensione di cella; vengono portati su una griglia quadrata in metri. La densità può essere un raster, una parola per tutto il combustibile (quanto è chiuso), o mancare se la legenda la indica. Un paesaggio FlamMap (.lcp) come quota contiene tutti i layer.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Quota</translation>
    </message>
    <message>
        <source>Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.</source>
        <translation>Quota in metri, in qualsiasi SR e dimensione di cella; o un file di paesaggio (.lcp), che contiene tutti i layer.</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Vegetazione</translation>
    </message>
    <message>
        <source>Codes of the vegetation, explained by the legend.</source>
        <translation>Codici della vegetazione, spiegati dalla legenda.</translation>
    </message>
    <message>
        <source>Vegetation density</source>
        <translation>Densità della vegetazione</translation>
    </message>
    <message>
        <source>Codes of the density of the vegetation; without it the densities come from the legend.</source>
        <translation>Codici della densità della vegetazione; senza di essi le densità vengono dalla legenda.</translation>
    </message>
    <message>
        <source>Legend of the vegetation codes</source>
        <translation>Legenda dei codici di vegetazione</translation>
    </message>
    <message>
        <source>What the vegetation codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Che cosa significano i codici di vegetazione: una legenda inclusa, o un vostro file CSV.</translation>
    </message>
    <message>
        <source>Fuel models of Anderson 1982</source>
        <translation>Modelli di combustibile di Anderson 1982</translation>
    </message>
    <message>
        <source>Canopy cover in percent as density: below 40 sparse, below 70 normal, else dense</source>
        <translation>Copertura delle chiome in percento come densità: sotto 40 rada, sotto 70 normale, altrimenti densa</translation>
    </message>
    <message>
        <source>CORINE Land Cover, level 3, three-digit codes</source>
        <translation>CORINE Land Cover, livello 3, codici a tre cifre</translation>
    </message>
    <message>
        <source>CORINE Land Cover as the raster of the European Environment Agency holds it: grid codes 1 to 44 in the order of level 3</source>
        <translation>CORINE Land Cover come raster dell'Agenzia europea dell'ambiente: codici da 1 a 44 nell'ordine del livello 3</translation>
    </message>
    <message>
        <source>Vegetation densities of Russo, Russo, Siettos 2016</source>
        <translation>Densità di vegetazione di Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Fuel map of Europe in 12 classes, as the PROPAGATOR fire model uses it</source>
        <translation>Carta dei combustibili d'Europa in 12 classi, come la usa il modello di incendio PROPAGATOR</translation>
    </message>
    <message>
        <source>Fuel types of the Canadian Forest Fire Behavior Prediction System</source>
        <translation>Tipi di combustibile del Canadian Forest Fire Behavior Prediction System</translation>
    </message>
    <message>
        <source>Fuel models of Portugal</source>
        <translation>Modelli di combustibile del Portogallo</translation>
    </message>
    <message>
        <source>Fuel models of the Chilean Kitral system, codes as in Cell2Fire</source>
        <translation>Modelli di combustibile del sistema cileno Kitral, codici come in Cell2Fire</translation>
    </message>
    <message>
        <source>Vegetation types of Russo, Russo, Siettos 2016</source>
        <translation>Tipi di vegetazione di Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Vegetation of the PROPAGATOR fire model in 7 classes</source>
        <translation>Vegetazione del modello di incendio PROPAGATOR in 7 classi</translation>
    </message>
    <message>
        <source>Fire behaviour fuel models of Scott and Burgan 2005</source>
        <translation>Modelli di combustibile di Scott e Burgan 2005</translation>
    </message>
    <message>
        <source>Tree cover density in percent</source>
        <translation>Densità della copertura arborea in percento</translation>
    </message>
    <message>
        <source>ESA WorldCover 10 m, codes of releases 2020 v100 and 2021 v200</source>
        <translation>ESA WorldCover 10 m, codici delle edizioni 2020 v100 e 2021 v200</translation>
    </message>
    <message>
        <source>as one class for all fuel</source>
        <translation>come una sola classe per tutto il combustibile</translation>
    </message>
    <message>
        <source>Sparse everywhere</source>
        <translation>Rada ovunque</translation>
    </message>
    <message>
        <source>Normal everywhere</source>
        <translation>Normale ovunque</translation>
    </message>
    <message>
        <source>Dense everywhere</source>
        <translation>Densa ovunque</translation>
    </message>
    <message>
        <source>As closed as the fuel around each cell is</source>
        <translation>Chiusa quanto il combustibile intorno a ogni cella</translation>
    </message>
    <message>
        <source>as a CSV file</source>
        <translation>come file CSV</translation>
    </message>
    <message>
        <source>Creation options, such as COMPRESS=ZSTD</source>
        <translation>Opzioni di creazione, ad es. COMPRESS=ZSTD</translation>
    </message>
    <message>
        <source>Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.</source>
        <translation>Opzione di creazione del driver COG di GDAL, ad es. COMPRESS=ZSTD.</translation>
    </message>
    <message>
        <source>Legend of the density codes</source>
        <translation>Legenda dei codici di densità</translation>
    </message>
    <message>
        <source>What the density codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Che cosa significano i codici di densità: una legenda inclusa, o un vostro file CSV.</translation>
    </message>
    <message>
        <source>CRS of the grid</source>
        <translation>SR della griglia</translation>
    </message>
    <message>
        <source>CRS of the grid, projected in metres [default: the "Elevation"'s if it is in metres, else the UTM zone].</source>
        <translation>SR della griglia, proiettato in metri [altrimenti quello di "Quota" se è in metri, o la zona UTM].</translation>
    </message>
    <message>
        <source>Cell size [m]</source>
        <translation>Dimensione della cella [m]</translation>
    </message>
    <message>
        <source>Cell size [default: the "Elevation"'s].</source>
        <translation>Dimensione della cella [altrimenti quella di "Quota"].</translation>
    </message>
    <message>
        <source>Extent (needs the CRS of the grid)</source>
        <translation>Estensione (richiede il SR della griglia)</translation>
    </message>
    <message>
        <source>Extent in the CRS of the grid [default: what all layers cover].</source>
        <translation>Estensione nel SR della griglia [altrimenti ciò che tutti i layer coprono].</translation>
    </message>
    <message>
        <source>Take the grid of this raster</source>
        <translation>Prendere la griglia di questo raster</translation>
    </message>
    <message>
        <source>Take the grid of this raster.</source>
        <translation>Prende la griglia di questo raster.</translation>
    </message>
    <message>
        <source>True CRS of the layers, such as dem=EPSG:32635</source>
        <translation>SR vero dei layer, ad es. dem=EPSG:32635</translation>
    </message>
    <message>
        <source>The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.</source>
        <translation>Il SR vero di dem, vegetation o density, o di tutti, dove un file non ne dice alcuno o uno sbagliato.</translation>
    </message>
    <message>
        <source>No-data values, such as dem=-9999; vegetation=255</source>
        <translation>Valori senza dati, ad es. dem=-9999; vegetation=255</translation>
    </message>
    <message>
        <source>Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says that all are data; several are separated by ;.</source>
        <translation>Valori che significano nessun dato in dem, vegetation o density, ad es. dem=-9999,32767; dem=none dice che tutti sono dati; più valori si separano con ;.</translation>
    </message>
    <message>
        <source>Bands, such as dem=1; vegetation=2</source>
        <translation>Bande, ad es. dem=1; vegetation=2</translation>
    </message>
    <message>
        <source>Band to read of dem, vegetation or density.</source>
        <translation>Banda da leggere di dem, vegetation o density.</translation>
    </message>
    <message>
        <source>Codes that the legend does not list</source>
        <translation>Codici che la legenda non elenca</translation>
    </message>
    <message>
        <source>What to do with codes that the legend does not list.</source>
        <translation>Che cosa fare dei codici che la legenda non elenca.</translation>
    </message>
    <message>
        <source>Refuse them</source>
        <translation>Rifiutarli</translation>
    </message>
    <message>
        <source>Take them as land without fuel</source>
        <translation>Prenderli come suolo senza combustibile</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of</source>
        <translation>Rifiutare ciò di cui si avviserebbe soltanto</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of.</source>
        <translation>Rifiuta ciò di cui si avviserebbe soltanto.</translation>
    </message>
    <message>
        <source>Allow network addresses and archives</source>
        <translation>Permettere indirizzi di rete e archivi</translation>
    </message>
    <message>
        <source>Allow "Elevation", "Vegetation" and "Vegetation density" to be network addresses or in archives.</source>
        <translation>Permette che "Quota", "Vegetazione" e "Densità della vegetazione" siano indirizzi di rete o stiano in archivi.</translation>
    </message>
    <message>
        <source>Most memory to use, such as 4GB</source>
        <translation>Memoria massima, ad es. 4GB</translation>
    </message>
    <message>
        <source>Refuse work that needs more, e.g. 4GB [default: most of what there is].</source>
        <translation>Rifiuta il lavoro che ne richiede di più, ad es. 4GB [altrimenti la maggior parte di quella che c'è].</translation>
    </message>
    <message>
        <source>Calibration, or the account (run.json) of an earlier run</source>
        <translation>Calibrazione, o resoconto (run.json) di un'esecuzione precedente</translation>
    </message>
    <message>
        <source>Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.</source>
        <translation>Prende parametri da un file TOML, o dal run.json di un'esecuzione precedente; ciò che si dà qui prevale.</translation>
    </message>
    <message>
        <source>Elevation on the common grid</source>
        <translation>Quota sulla griglia comune</translation>
    </message>
    <message>
        <source>Vegetation classes on the common grid</source>
        <translation>Classi di vegetazione sulla griglia comune</translation>
    </message>
    <message>
        <source>Density classes on the common grid</source>
        <translation>Classi di densità sulla griglia comune</translation>
    </message>
    <message>
        <source>Effect of the vegetation, where the legend gives numbers in place of classes</source>
        <translation>Effetto della vegetazione, dove la legenda dà numeri al posto di classi</translation>
    </message>
    <message>
        <source>Effect of the density, where the legend gives numbers in place of classes</source>
        <translation>Effetto della densità, dove la legenda dà numeri al posto di classi</translation>
    </message>
    <message>
        <source>Rate of spread on flat calm dry ground, where the legend gives it</source>
        <translation>Velocità di propagazione su terreno piano e asciutto senza vento, dove la legenda la dà</translation>
    </message>
    <message>
        <source>Load of dead fuel, where the legend gives it</source>
        <translation>Carico di combustibile morto, dove la legenda lo dà</translation>
    </message>
    <message>
        <source>Load of live fuel, where the legend gives it</source>
        <translation>Carico di combustibile vivo, dove la legenda lo dà</translation>
    </message>
    <message>
        <source>Heat content of the fuel, where the legend gives it</source>
        <translation>Potere calorifico del combustibile, dove la legenda lo dà</translation>
    </message>
    <message>
        <source>Moisture of the live fuel, where the legend gives it</source>
        <translation>Umidità del combustibile vivo, dove la legenda la dà</translation>
    </message>
    <message>
        <source>Account of the run</source>
        <translation>Resoconto dell'esecuzione</translation>
    </message>
    <message>
        <source>Folder for all files</source>
        <translation>Cartella per tutti i file</translation>
    </message>
    <message>
        <source>Spread network</source>
        <translation>Rete di propagazione</translation>
    </message>
    <message>
        <source>Find how likely fire spreads from each cell to its neighbours.</source>
        <translation>Trova con quale probabilità il fuoco passa da ogni cella alle vicine.</translation>
    </message>
    <message>
        <source>Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). Wind and slope then act on the times; so make a network without times for fires without a duration.</source>
        <translation>Le bande da 1 a 8 contengono la probabilità che il fuoco passi verso N, NE, E, SE, S, SO, O e NO. Se si danno anche i tempi, le bande da 9 a 16 contengono i secondi che occorrono, e la banda 17 il calore che la cella libera (kJ/m2). Vento e pendenza agiscono allora sui tempi; per incendi senza durata fate dunque una rete senza tempi.</translation>
    </message>
    <message>
        <source>Cells with fuel</source>
        <translation>Celle con combustibile</translation>
    </message>
    <message>
        <source>Spread model</source>
        <translation>Modello di propagazione</translation>
    </message>
    <message>
        <source>How fire gets from a cell to its neighbours; all are described below.</source>
        <translation>Come il fuoco arriva da una cella alle vicine; tutti sono descritti sotto.</translation>
    </message>
    <message>
        <source>Alexandridis: cellular automaton of vegetation type, density, slope and wind</source>
        <translation>Alexandridis: automa cellulare di tipo di vegetazione, densità, pendenza e vento</translation>
    </message>
    <message>
        <source>Artificial forest: the probability of catching fire is the fuel of the target cell</source>
        <translation>Bosco artificiale: la probabilità di prendere fuoco è il combustibile della cella di arrivo</translation>
    </message>
    <message>
        <source>Raster: your own probabilities, and perhaps travel times, from another fire model</source>
        <translation>Raster: probabilità proprie, ed eventualmente tempi, da un altro modello di incendio</translation>
    </message>
    <message>
        <source>Wind speed [m/s]</source>
        <translation>Velocità del vento [m/s]</translation>
    </message>
    <message>
        <source>Wind speed at mid-flame height in m/s, or a raster of it on any grid.</source>
        <translation>Velocità del vento a metà altezza della fiamma in m/s, o un suo raster su qualsiasi griglia.</translation>
    </message>
    <message>
        <source>Wind from [degrees clockwise from north]</source>
        <translation>Vento da [gradi in senso orario da nord]</translation>
    </message>
    <message>
        <source>Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.</source>
        <translation>Direzione da cui viene il vento, in senso orario da nord: 270 è vento da ovest; un numero o un raster.</translation>
    </message>
    <message>
        <source>Tell times too (for fires with a duration)</source>
        <translation>Dare anche i tempi (per incendi con una durata)</translation>
    </message>
    <message>
        <source>Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.</source>
        <translation>Dà anche quanto il fuoco impiega da cella a cella (bande da 9 a 16, secondi) e il calore di ogni cella.</translation>
    </message>
    <message>
        <source>as a raster</source>
        <translation>come raster</translation>
    </message>
    <message>
        <source>Wind towards east and north, in place of speed and direction [m/s]</source>
        <translation>Vento verso est e nord, al posto di velocità e direzione [m/s]</translation>
    </message>
    <message>
        <source>Components of the wind towards east and north, in place of the two above: rasters on any grid.</source>
        <translation>Componenti del vento verso est e nord, al posto dei due sopra: raster su qualsiasi griglia.</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel (8 % is 0.08)</source>
        <translation>Umidità del combustibile morto fine (8 % è 0.08)</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.</source>
        <translation>Umidità del combustibile morto fine come quota del suo peso secco (8 % è 0.08 o 8%), o un suo raster.</translation>
    </message>
    <message>
        <source>Neighbours that a cell can light</source>
        <translation>Vicine che una cella può accendere</translation>
    </message>
    <message>
        <source>Cells to which fire can spread from a cell.</source>
        <translation>Celle a cui il fuoco può passare da una cella.</translation>
    </message>
    <message>
        <source>All eight</source>
        <translation>Tutte e otto</translation>
    </message>
    <message>
        <source>The four that share a side</source>
        <translation>Le quattro che condividono un lato</translation>
    </message>
    <message>
        <source>Parameters of the spread model, such as p0=0.5</source>
        <translation>Parametri del modello di propagazione, ad es. p0=0.5</translation>
    </message>
    <message>
        <source>Parameter of the spread model, e.g. p0=0.5; several are separated by ;.</source>
        <translation>Parametro del modello di propagazione, ad es. p0=0.5; più valori si separano con ;.</translation>
    </message>
    <message>
        <source>File with the probabilities for other tools (.mtx, .npz)</source>
        <translation>File con le probabilità per altri programmi (.mtx, .npz)</translation>
    </message>
    <message>
        <source>Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or .graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.</source>
        <translation>Scrive anche le probabilità per altri programmi: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) o .graphml (fino a 20,000 celle con combustibile). Le celle sono numerate riga per riga dall'alto a sinistra.</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; with 8 by 0.002 and 3.4 %. Every command reads such files.</source>
        <translation>Bit per numero nel file. Con 16 le probabilità sono errate di 8e-6 al massimo, i tempi e il calore dello 0.013 %; con 8, di 0.002 e del 3.4 %. Ogni comando legge questi file.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Esatto</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bit</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bit</translation>
    </message>
    <message>
        <source>Where a line can be held</source>
        <translation>Dove si può tenere una linea</translation>
    </message>
    <message>
        <source>Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by it.</source>
        <translation>Valuta da 0 a 1 quanto bene si può tenere una linea in ogni cella: quanto vale la migliore linea a portata (creste, fondivalle, strade, fiumi, margini del combustibile), con la pendenza per le macchine e l'accesso. I piani la seguono.</translation>
    </message>
    <message>
        <source>The weights have no source for your region: they are yours to set.</source>
        <translation>I pesi non hanno una fonte per la vostra regione: sta a voi fissarli.</translation>
    </message>
    <message>
        <source>Mean suitability where there is fuel</source>
        <translation>Idoneità media dove c'è combustibile</translation>
    </message>
    <message>
        <source>Roads and tracks</source>
        <translation>Strade e piste</translation>
    </message>
    <message>
        <source>Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which crews drive; those that stop fire are barriers too.</source>
        <translation>Strade e piste (linee o un raster), lungo le quali le fasce sono più facili da costruire e da tenere, e che le squadre percorrono; quelle che fermano il fuoco sono anche barriere.</translation>
    </message>
    <message>
        <source>Rivers and lakes</source>
        <translation>Fiumi e laghi</translation>
    </message>
    <message>
        <source>Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are barriers too.</source>
        <translation>Fiumi e laghi (linee, aree, un raster), lungo i quali le fasce sono più facili da tenere; quelli che fermano il fuoco sono anche barriere.</translation>
    </message>
    <message>
        <source>What lines of the ground are worth, such as ridge=0.8; reach=60</source>
        <translation>Quanto valgono le linee del terreno, p. es. ridge=0.8; reach=60</translation>
    </message>
    <message>
        <source>What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; several are separated by ;.</source>
        <translation>Quanto vale una linea, o una distanza, p. es. ridge=0.8, valley=0 o reach=60; più di uno si separano con ;.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines</source>
        <translation>Comparti delimitati da linee di controllo</translation>
    </message>
    <message>
        <source>Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: potential operational delineations (PODs), on which crews agree before a fire.</source>
        <translation>Dividere il paesaggio in comparti di dimensione simile, delimitati dalle linee più facili da tenere: delimitazioni operative potenziali (PODs), che le squadre concordano prima di un incendio.</translation>
    </message>
    <message>
        <source>Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. The second layer of the file holds the borders.</source>
        <translation>Ogni comparto ha il suo combustibile, i suoi inneschi e valori, ciò che brucia negli incendi simulati e la qualità del suo confine. Il secondo layer del file contiene i confini.</translation>
    </message>
    <message>
        <source>Compartments</source>
        <translation>Comparti</translation>
    </message>
    <message>
        <source>Borders in kilometres</source>
        <translation>Confini in chilometri</translation>
    </message>
    <message>
        <source>Mean suitability of the borders</source>
        <translation>Idoneità media dei confini</translation>
    </message>
    <message>
        <source>Size of the compartments, such as 500ha</source>
        <translation>Dimensione dei comparti, ad es. 500ha</translation>
    </message>
    <message>
        <source>Size of the compartments, hectares of fuel; none is larger than one and a half times this.</source>
        <translation>Dimensione dei comparti, in ettari di combustibile; nessuno supera una volta e mezza questo valore.</translation>
    </message>
    <message>
        <source>Values at risk</source>
        <translation>Valori a rischio</translation>
    </message>
    <message>
        <source>Values at risk: a raster, or polygons or points with "Field with the value" [default: 1 on fuel].</source>
        <translation>Valori a rischio: un raster, o poligoni o punti con "Campo con il valore" [altrimenti 1 sul combustibile].</translation>
    </message>
    <message>
        <source>How long fires burn, such as 8h</source>
        <translation>Quanto durano gli incendi, ad es. 8h</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: lognormal:8h,0.7, an assumption].</source>
        <translation>Quanto durano gli incendi: 8h, un elenco che le esecuzioni prendono a turno (4h,8h), lognormal:8h,0.7 (mediana e sigma), uniform:2h,12h, o weather [altrimenti lognormal:8h,0.7, un'ipotesi].</translation>
    </message>
    <message>
        <source>Ignition points</source>
        <translation>Punti di innesco</translation>
    </message>
    <message>
        <source>Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of ignition probability [default: one random cell with fuel a run].</source>
        <translation>Punti, poligoni (perimetri che già bruciano; qualsiasi file vettoriale, o CSV con x e y) o un raster della probabilità di innesco [altrimenti una cella a caso con combustibile per esecuzione].</translation>
    </message>
    <message>
        <source>Number of fires</source>
        <translation>Numero di incendi</translation>
    </message>
    <message>
        <source>Simulated fires.</source>
        <translation>Incendi simulati.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <source>Seed of all draws.</source>
        <translation>Seme di tutti i sorteggi.</translation>
    </message>
    <message>
        <source>How much more the worst ground counts than the best</source>
        <translation>Quanto conta di più il terreno peggiore rispetto al migliore</translation>
    </message>
    <message>
        <source>Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.</source>
        <translation>Numero di volte che il terreno peggiore conta quanto il migliore, da 1 a 100; con 1 si chiedono i confini più corti.</translation>
    </message>
    <message>
        <source>Field with the value</source>
        <translation>Campo con il valore</translation>
    </message>
    <message>
        <source>Column of the value polygons or points [default: 1 for each].</source>
        <translation>Colonna dei poligoni o punti di valore [altrimenti 1 per ciascuno].</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>I valori sono</translation>
    </message>
    <message>
        <source>What the numbers of "Values at risk" are: so much in each cell of the raster, polygon or point (people), the sum of which is kept; or so much a hectare.</source>
        <translation>Che cosa sono i numeri di "Valori a rischio": tanto in ogni cella del raster, poligono o punto (persone), di cui si conserva la somma; o tanto per ettaro.</translation>
    </message>
    <message>
        <source>So much in each cell, polygon or point</source>
        <translation>Tanto in ogni cella, poligono o punto</translation>
    </message>
    <message>
        <source>So much a hectare</source>
        <translation>Tanto per ettaro</translation>
    </message>
    <message>
        <source>Several values at risk, such as people=villages.gpkg,weight=2</source>
        <translation>Più valori a rischio, ad es. people=villages.gpkg,weight=2</translation>
    </message>
    <message>
        <source>Several values at risk, each as a name and a file, with its field, a weight (what a unit counts in the sum that is planned for) and as=density after it as needed; several are separated by ;, each is told by name.</source>
        <translation>Più valori a rischio, ciascuno come nome e file, seguito se serve dal suo campo, da un peso (quanto conta un'unità nella somma per cui si pianifica) e da as=density; più valori si separano con ;, ciascuno è detto per nome.</translation>
    </message>
    <message>
        <source>Conditions on features, such as barriers=highway = 'primary'</source>
        <translation>Condizioni sugli elementi, ad es. barriers=highway = 'primary'</translation>
    </message>
    <message>
        <source>Take only features that fit a condition, with the name of the layer before it, such as barriers=highway = 'primary'; several are separated by ;.</source>
        <translation>Prende solo gli elementi che soddisfano una condizione, con il nome del layer davanti, ad es. barriers=highway = 'primary'; più condizioni si separano con ;.</translation>
    </message>
    <message>
        <source>Use of the ignition points</source>
        <translation>Uso dei punti di innesco</translation>
    </message>
    <message>
        <source>With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or start where such fires of the past are dense.</source>
        <translation>Con punti o poligoni: le esecuzioni li prendono a turno (il seme sorteggia l'ordine), partono da tutti, o partono dove tali incendi del passato sono densi.</translation>
    </message>
    <message>
        <source>One for each fire, in turn</source>
        <translation>Uno per incendio, a turno</translation>
    </message>
    <message>
        <source>All at once in every fire</source>
        <translation>Tutti insieme in ogni incendio</translation>
    </message>
    <message>
        <source>More fires where they are dense</source>
        <translation>Più incendi dove sono densi</translation>
    </message>
    <message>
        <source>Ignition points without fuel</source>
        <translation>Punti di innesco senza combustibile</translation>
    </message>
    <message>
        <source>What to do with points and polygons off the landscape or without fuel.</source>
        <translation>Che cosa fare di punti e poligoni fuori dal paesaggio o senza combustibile.</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Lasciarli fuori</translation>
    </message>
    <message>
        <source>Column with the hour of each ignition</source>
        <translation>Colonna con l'ora di ogni innesco</translation>
    </message>
    <message>
        <source>Column of the ignitions that tells when each is lit, in hours after the start of the run.</source>
        <translation>Colonna degli inneschi che dice quando ciascuno si accende, in ore dopo l'inizio dell'esecuzione.</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Tizzoni e faville</translation>
    </message>
    <message>
        <source>Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.</source>
        <translation>Tizzoni che volano davanti al fuoco: on, o numeri come rate=12,longest=1000 al posto di quelli ipotizzati.</translation>
    </message>
    <message>
        <source>When crews contain a fire, such as 6h</source>
        <translation>Quando le squadre contengono un incendio, ad es. 6h</translation>
    </message>
    <message>
        <source>When crews contain each fire: a time or a distribution as for "How long fires burn", or a direct attack at such a time, which fails if the fire is too large or too fierce by then: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].</source>
        <translation>Quando le squadre contengono ogni incendio: un tempo o una distribuzione come per "Quanto durano gli incendi", o un attacco diretto in quel momento, che fallisce se l'incendio è ormai troppo grande o intenso: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha sopra) [altrimenti mai].</translation>
    </message>
    <message>
        <source>How often a break holds, such as 0.47</source>
        <translation>Quanto spesso un viale tiene, ad es. 0.47</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: 0.47, an assumption].</source>
        <translation>Quanto spesso un pezzo di viale tiene in un'esecuzione: una quota (0.47 sul campo), flame (per larghezza e intensità del fuoco, Wilson 1988) o flame:flames (1.5 lunghezze di fiamma); i pezzi hanno 400 m, o come in 0.47:800 [altrimenti 0.47, un'ipotesi].</translation>
    </message>
    <message>
        <source>How often a barrier holds, such as 0.9</source>
        <translation>Quanto spesso una barriera tiene, ad es. 0.9</translation>
    </message>
    <message>
        <source>Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.</source>
        <translation>Quota delle esecuzioni in cui un pezzo delle barriere tiene; sorteggiata a parte dai viali.</translation>
    </message>
    <message>
        <source>Stations of crews whom breaks wait for</source>
        <translation>Basi delle squadre che i viali aspettano</translation>
    </message>
    <message>
        <source>Points or areas that crews set out from: a stretch of break holds only against fire that comes after them [default: crews are everywhere].</source>
        <translation>Punti o aree da cui partono le squadre: un pezzo di viale tiene solo contro il fuoco che arriva dopo di loro [altrimenti le squadre sono ovunque].</translation>
    </message>
    <message>
        <source>Travel of crews, such as road=40,off=3,delay=10</source>
        <translation>Spostamento delle squadre, ad es. road=40,off=3,delay=10</translation>
    </message>
    <message>
        <source>How they travel: speed on roads and off them in km/h, and minutes from the start of the fire until they leave [default: road=40,off=3,delay=10, assumptions].</source>
        <translation>Come si spostano: velocità su strada e fuori in km/h, e minuti dall'inizio dell'incendio alla partenza [altrimenti road=40,off=3,delay=10, ipotesi].</translation>
    </message>
    <message>
        <source>Fires without an end by time</source>
        <translation>Incendi senza fine a tempo</translation>
    </message>
    <message>
        <source>Fires end by themselves and breaks hold in every fire unless "How often a break holds" says otherwise, as in the paper.</source>
        <translation>Gli incendi finiscono da sé e i viali tengono in ogni incendio, se "Quanto spesso un viale tiene" non dice altro, come nell'articolo.</translation>
    </message>
    <message>
        <source>Table of weather</source>
        <translation>Tabella meteo</translation>
    </message>
    <message>
        <source>Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2.</source>
        <translation>Insieme di situazioni meteo, di cui ogni esecuzione ne estrae una: un file CSV con wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; o una rosa dei venti come rose:NW=5x0.4,N=8x0.2.</translation>
    </message>
    <message>
        <source>as a wind rose: rose:NW=5x0.4,N=8x0.2</source>
        <translation>come rosa dei venti: rose:NW=5x0.4,N=8x0.2</translation>
    </message>
    <message>
        <source>Time of each line of the table of weather, such as 1h</source>
        <translation>Durata di ogni riga della tabella meteo, ad es. 1h</translation>
    </message>
    <message>
        <source>The lines of the weather follow each other, and each lasts so long, e.g. 1h.</source>
        <translation>Le righe del meteo si susseguono, e ciascuna dura tanto, ad es. 1h.</translation>
    </message>
    <message>
        <source>Columns of the table of weather, such as wind_speed=FF</source>
        <translation>Colonne della tabella meteo, ad es. wind_speed=FF</translation>
    </message>
    <message>
        <source>Name of a column of the weather, e.g. wind_speed=FF; several are separated by ;.</source>
        <translation>Nome di una colonna del meteo, ad es. wind_speed=FF; più nomi si separano con ;.</translation>
    </message>
    <message>
        <source>Units of the table of weather, such as wind_speed=kn</source>
        <translation>Unità della tabella meteo, ad es. wind_speed=kn</translation>
    </message>
    <message>
        <source>Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; several are separated by ;.</source>
        <translation>Unità di una colonna del meteo che non la dice, ad es. wind_speed=kn; più unità si separano con ;.</translation>
    </message>
    <message>
        <source>Columns of the table of weather to leave out</source>
        <translation>Colonne della tabella meteo da lasciare fuori</translation>
    </message>
    <message>
        <source>Columns of the weather to leave out, separated by commas.</source>
        <translation>Colonne del meteo da lasciare fuori, separate da virgole.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, and their borders</source>
        <translation>Comparti delimitati da linee di controllo, e i loro confini</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, without outlines</source>
        <translation>Comparti delimitati da linee di controllo, senza contorni</translation>
    </message>
    <message>
        <source>Borders of the compartments, without lines</source>
        <translation>Confini dei comparti, senza linee</translation>
    </message>
    <message>
        <source>Plan fire breaks</source>
        <translation>Pianificare viali tagliafuoco</translation>
    </message>
    <message>
        <source>Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and with the breaks.</source>
        <translation>Pianifica viali tagliafuoco a partire da layer: dove tagliare, che cosa costruire per primo e quanto spesso brucia ogni cella senza e con i viali.</translation>
    </message>
    <message>
        <source>Cells cut</source>
        <translation>Celle tagliate</translation>
    </message>
    <message>
        <source>Area cut in hectares</source>
        <translation>Superficie tagliata in ettari</translation>
    </message>
    <message>
        <source>Mean burnt share without breaks</source>
        <translation>Quota bruciata media senza viali tagliafuoco</translation>
    </message>
    <message>
        <source>Mean burnt share with the breaks</source>
        <translation>Quota bruciata media con i viali tagliafuoco</translation>
    </message>
    <message>
        <source>Area where nothing may be cut</source>
        <translation>Area dove nulla può essere tagliato</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.</source>
        <translation>Area (raster o poligoni; le linee prendono le celle che toccano) dove nulla può essere tagliato.</translation>
    </message>
    <message>
        <source>Existing barriers</source>
        <translation>Barriere esistenti</translation>
    </message>
    <message>
        <source>Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and cost nothing.</source>
        <translation>Viali, strade e fiumi esistenti (raster, linee o poligoni): tutte le celle che attraversano non hanno combustibile e non costano nulla.</translation>
    </message>
    <message>
        <source>Budget, such as 10%, 5ha or 20000eur</source>
        <translation>Budget, ad es. 10%, 5ha o 20000eur</translation>
    </message>
    <message>
        <source>How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or money such as 20000eur, in the currency of the costs.</source>
        <translation>Quanto tagliare: una quota delle celle con combustibile come 10% o 0.1, una superficie come 5ha, o denaro come 20000eur, nella valuta dei costi.</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Metodo di ordinamento</translation>
    </message>
    <message>
        <source>By which cells are ranked; higher is cut earlier. All are described below.</source>
        <translation>Secondo che cosa si ordinano le celle; più alto si taglia prima. Tutti sono descritti sotto.</translation>
    </message>
    <message>
        <source>Betweenness centrality: cells that lie on many fastest routes of fire</source>
        <translation>Centralità di intermediazione: celle che stanno su molti dei percorsi più rapidi del fuoco</translation>
    </message>
    <message>
        <source>Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves</source>
        <translation>Centralità di Bonacich: celle attraverso cui il fuoco raggiunge celle a loro volta facili da raggiungere</translation>
    </message>
    <message>
        <source>Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere</source>
        <translation>Centralità di vicinanza: celle che il fuoco raggiunge presto da ovunque, o da cui raggiunge presto ovunque</translation>
    </message>
    <message>
        <source>Compartments: a square grid of bands that encloses equal ones</source>
        <translation>Comparti: una maglia quadrata di fasce che racchiude comparti uguali</translation>
    </message>
    <message>
        <source>Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone</source>
        <translation>Intermediazione a flusso di corrente: celle per cui passa la propagazione lungo qualsiasi percorso, non solo il più rapido</translation>
    </message>
    <message>
        <source>Degree: cells that are lit by, or light, their neighbours most</source>
        <translation>Grado: celle che più sono accese dalle vicine, o più le accendono</translation>
    </message>
    <message>
        <source>Defensible fuel profile zones (DFPZ): broad bands along roads and ridges</source>
        <translation>Zone di combustibile difendibili (DFPZ): fasce larghe lungo strade e crinali</translation>
    </message>
    <message>
        <source>Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first</source>
        <translation>Dissezione: muri tra comparti con tagli minimi annidati, prima quelli che più risparmiano per il loro costo</translation>
    </message>
    <message>
        <source>Dominator: exact gain of cutting one cell, found anew after every few cuts</source>
        <translation>Dominatore: guadagno esatto dal taglio di una cella, ritrovato dopo ogni pochi tagli</translation>
    </message>
    <message>
        <source>DomiRank: cells that dominate their neighbourhood when neighbours compete</source>
        <translation>DomiRank: celle che dominano il loro intorno quando le vicine competono</translation>
    </message>
    <message>
        <source>Downstream protection value: cells from which most value was lit, found anew after every few cuts</source>
        <translation>Valore di protezione a valle: celle da cui è stato acceso più valore, ritrovate dopo ogni pochi tagli</translation>
    </message>
    <message>
        <source>Eigenvector centrality: cells next to the cells that matter most, all in one place of the map</source>
        <translation>Centralità di autovettore: celle accanto alle celle che più contano, tutte in un luogo della carta</translation>
    </message>
    <message>
        <source>Flammability: most flammable cells first, the conventional policy, which looks at each cell alone</source>
        <translation>Infiammabilità: prima le celle più infiammabili, la prassi usuale, che guarda ogni cella da sola</translation>
    </message>
    <message>
        <source>Group betweenness: built cell by cell, each covers fastest routes that the group leaves open</source>
        <translation>Intermediazione di gruppo: formato cella per cella, ognuna copre percorsi più rapidi che il gruppo lascia aperti</translation>
    </message>
    <message>
        <source>Influence: cells by way of which fires with a clock take most, found anew after every few cuts on the same draws</source>
        <translation>Influenza: celle attraverso le quali gli incendi con orologio bruciano di più, ritrovate da capo ogni pochi tagli con le stesse estrazioni</translation>
    </message>
    <message>
        <source>Information centrality: cells that many parallel ways of spread join closely to all others</source>
        <translation>Centralità di informazione: celle che molte vie parallele di propagazione uniscono strettamente a tutte le altre</translation>
    </message>
    <message>
        <source>PageRank: cells that a fire wandering at random from cell to cell is often in</source>
        <translation>PageRank: celle in cui si trova spesso un fuoco che vaga a caso di cella in cella</translation>
    </message>
    <message>
        <source>Percolation centrality: cells on many fastest routes from where fires start</source>
        <translation>Centralità di percolazione: celle su molti dei percorsi più rapidi da dove iniziano gli incendi</translation>
    </message>
    <message>
        <source>Random: cells in random order, the baseline that every plan must beat</source>
        <translation>Caso: celle in ordine casuale, il riferimento che ogni piano deve superare</translation>
    </message>
    <message>
        <source>Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them</source>
        <translation>Aree di trattamento collocate strategicamente (SPLAT): macchie sfalsate che rallentano il fuoco, senza passaggi diritti</translation>
    </message>
    <message>
        <source>Stripes: parallel bands across a direction, the plainest pattern of practice</source>
        <translation>Strisce: fasce parallele di traverso a una direzione, lo schema più semplice della pratica</translation>
    </message>
    <message>
        <source>Unit of a budget that is a plain number</source>
        <translation>Unità di un budget che è un numero semplice</translation>
    </message>
    <message>
        <source>What a plain number for "Budget" counts: a share of the fuel, hectares, or money [default: share].</source>
        <translation>Che cosa conta un numero semplice in "Budget": una quota del combustibile, ettari, o denaro [altrimenti quota].</translation>
    </message>
    <message>
        <source>Share of the fuel (0 to 1)</source>
        <translation>Quota del combustibile (da 0 a 1)</translation>
    </message>
    <message>
        <source>Hectares</source>
        <translation>Ettari</translation>
    </message>
    <message>
        <source>Money</source>
        <translation>Denaro</translation>
    </message>
    <message>
        <source>Parameters of the ranking, such as beta=0.5; width=60</source>
        <translation>Parametri del metodo di ordinamento, ad es. beta=0.5; width=60</translation>
    </message>
    <message>
        <source>Parameter of the ranking, e.g. beta=0.5; several are separated by ;.</source>
        <translation>Parametro del metodo di ordinamento, ad es. beta=0.5; più valori si separano con ;.</translation>
    </message>
    <message>
        <source>Share of the spread that a break lets through</source>
        <translation>Quota della propagazione che un viale lascia passare</translation>
    </message>
    <message>
        <source>Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.</source>
        <translation>Quota della sua probabilità di propagazione che una cella trattata conserva; 0 è un viale perfetto, quelli veri lasciano passare.</translation>
    </message>
    <message>
        <source>Least width of the breaks [m]</source>
        <translation>Larghezza minima dei viali [m]</translation>
    </message>
    <message>
        <source>Least width of the breaks, rounded up to whole cells [default: one cell, or the best for "Share of the spread that a break lets through"].</source>
        <translation>Larghezza minima dei viali, arrotondata a celle intere [altrimenti una cella, o la migliore per "Quota della propagazione che un viale lascia passare"].</translation>
    </message>
    <message>
        <source>Improve the breaks on simulated fires (takes longer)</source>
        <translation>Migliorare i viali su incendi simulati (richiede più tempo)</translation>
    </message>
    <message>
        <source>Improve the breaks by local search on simulated fires; takes longer.</source>
        <translation>Migliora i viali con una ricerca locale su incendi simulati; richiede più tempo.</translation>
    </message>
    <message>
        <source>Fires that the plan is made for</source>
        <translation>Incendi per cui il piano è fatto</translation>
    </message>
    <message>
        <source>What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).</source>
        <translation>Che cosa deve essere piccolo: la perdita dell'incendio medio, o quella del decimo peggiore degli incendi (CVaR).</translation>
    </message>
    <message>
        <source>The mean fire</source>
        <translation>L'incendio medio</translation>
    </message>
    <message>
        <source>The worst tenth of the fires</source>
        <translation>Il decimo peggiore degli incendi</translation>
    </message>
    <message>
        <source>Width of breaks that are lines [m]</source>
        <translation>Larghezza dei viali che sono linee [m]</translation>
    </message>
    <message>
        <source>Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length times their width. With "How often a break holds" flame, auto is the width with which fires take least. cells cuts whole cells, as in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.</source>
        <translation>Larghezza delle linee di cui sono fatti i viali, ad es. 12m, anche minore di una cella; il budget conta la loro lunghezza per la loro larghezza. Con "Quanto spesso un viale tiene" flame, auto è la larghezza con cui gli incendi bruciano meno. cells taglia celle intere, come nell'articolo. Predefinito: linee larghe quanto una cella, al massimo 30 m, dove gli incendi hanno un orologio e i viali non lasciano passare il fuoco.</translation>
    </message>
    <message>
        <source>Treatments (CSV, or default)</source>
        <translation>Trattamenti (CSV, o default)</translation>
    </message>
    <message>
        <source>Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires burn with what they leave [default: all segments alike, by "Share of the spread that a break lets through"].</source>
        <translation>Tabella dei trattamenti (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), o default: ogni tratto riceve quello che più risparmia per il suo costo, un budget in denaro è ciò che costano, e gli incendi bruciano con ciò che lasciano [altrimenti tutti i tratti uguali, secondo "Quota della propagazione che un viale lascia passare"].</translation>
    </message>
    <message>
        <source>as a word</source>
        <translation>come parola</translation>
    </message>
    <message>
        <source>Breaks that stand already</source>
        <translation>Viali che esistono già</translation>
    </message>
    <message>
        <source>Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.</source>
        <translation>Viali che esistono già (linee, poligoni o un raster di cui ogni parte connessa è uno): gli incendi li incontrano con e senza il piano, cedono come quelli nuovi e il loro combustibile ricresce se non sono mantenuti.</translation>
    </message>
    <message>
        <source>as polygons or lines</source>
        <translation>come poligoni o linee</translation>
    </message>
    <message>
        <source>Years of building and upkeep</source>
        <translation>Anni di costruzione e manutenzione</translation>
    </message>
    <message>
        <source>Number of years over which the breaks are built and kept up; 1: all is built at once.</source>
        <translation>Numero di anni in cui i viali sono costruiti e mantenuti; 1: tutto si costruisce in una volta.</translation>
    </message>
    <message>
        <source>Budget of each year, such as 500ha</source>
        <translation>Budget di ogni anno, ad es. 500ha</translation>
    </message>
    <message>
        <source>What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share [default: what all breaks cost, over the years].</source>
        <translation>Ciò che ogni anno permette per la manutenzione, pagata per prima, e la costruzione: 500ha, 20000eur o una quota [altrimenti quanto costano tutti i viali, diviso per gli anni].</translation>
    </message>
    <message>
        <source>Fires that start in a year</source>
        <translation>Incendi che iniziano in un anno</translation>
    </message>
    <message>
        <source>Number of fires that start in a year.</source>
        <translation>Numero di incendi che iniziano in un anno.</translation>
    </message>
    <message>
        <source>Discount rate a year, such as 3%</source>
        <translation>Tasso di sconto annuo, ad es. 3%</translation>
    </message>
    <message>
        <source>Rate a year, such as 3%, at which later costs and losses count less.</source>
        <translation>Tasso annuo, ad es. 3%, con cui costi e perdite successivi contano meno.</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back</source>
        <translation>Anni finché il combustibile trattato è ricresciuto</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "Treatments", or agricultural=3,shrubs=4,pines=4, an assumption].</source>
        <translation>Anni finché il combustibile trattato è ricresciuto: 4, o agricultural=3,shrubs=4,pines=8 [altrimenti quelli di "Trattamenti", o agricultural=3,shrubs=4,pines=4, un'ipotesi].</translation>
    </message>
    <message>
        <source>Cost of treating anew, as a share of treating first</source>
        <translation>Costo di un nuovo trattamento, come quota del primo</translation>
    </message>
    <message>
        <source>What treating anew costs, as a share of treating first.</source>
        <translation>Quanto costa un nuovo trattamento, come quota del primo.</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare</source>
        <translation>Costo del taglio per ettaro</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost", or classes such as agricultural=500,shrubs=900,pines=1500.</source>
        <translation>Costo del taglio per ettaro: un raster, poligoni con "Campo con il costo", o classi come agricultural=500,shrubs=900,pines=1500.</translation>
    </message>
    <message>
        <source>as classes: agricultural=500,pines=1500</source>
        <translation>come classi: agricultural=500,pines=1500</translation>
    </message>
    <message>
        <source>Field with the cost</source>
        <translation>Campo con il costo</translation>
    </message>
    <message>
        <source>Column of the cost polygons.</source>
        <translation>Colonna dei poligoni di costo.</translation>
    </message>
    <message>
        <source>Cost per hectare where none is known</source>
        <translation>Costo per ettaro dove nessuno è noto</translation>
    </message>
    <message>
        <source>Cost per hectare where "Cost of cutting per hectare" tells none; alone, everywhere [default: nothing is cut there].</source>
        <translation>Costo per ettaro dove "Costo del taglio per ettaro" non ne dice; da solo, ovunque [altrimenti lì non si taglia].</translation>
    </message>
    <message>
        <source>Area outside of which nothing may be cut</source>
        <translation>Area fuori dalla quale nulla può essere tagliato</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.</source>
        <translation>Area (raster o poligoni; le linee prendono le celle che toccano) fuori dalla quale nulla può essere tagliato.</translation>
    </message>
    <message>
        <source>Cells that protected and allowed areas keep</source>
        <translation>Celle che le aree protette e permesse conservano</translation>
    </message>
    <message>
        <source>Cells that "Area where nothing may be cut" and "Area outside of which nothing may be cut" keep from being cut: all with a part inside the one or outside the other, or those whose centre is.</source>
        <translation>Celle che "Area dove nulla può essere tagliato" e "Area fuori dalla quale nulla può essere tagliato" preservano dal taglio: tutte quelle con una parte dentro l'una o fuori dall'altra, o quelle il cui centro lo è.</translation>
    </message>
    <message>
        <source>Cells with any part in the area</source>
        <translation>Celle con una parte qualsiasi nell'area</translation>
    </message>
    <message>
        <source>Cells whose centre is in the area</source>
        <translation>Celle il cui centro è nell'area</translation>
    </message>
    <message>
        <source>Area of interest that is planned for</source>
        <translation>Area di interesse per cui si pianifica</translation>
    </message>
    <message>
        <source>Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start and burn there too.</source>
        <translation>Area di interesse (raster o poligoni) per cui si pianifica: fuori non si taglia nulla, ma gli incendi partono e bruciano anche lì.</translation>
    </message>
    <message>
        <source>How much more a break counts in bad ground (0: all ground alike)</source>
        <translation>Quanto più conta una fascia su terreno cattivo (0: tutto uguale)</translation>
    </message>
    <message>
        <source>How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].</source>
        <translation>Quanto più conta una fascia sul terreno peggiore che su una cresta, una strada, un fiume o il margine del combustibile; 0: tutto il terreno uguale, come nell'articolo [predefinito: 1.5 dove il terreno è noto e ha rilievo].</translation>
    </message>
    <message>
        <source>Steeper ground is not cut [degrees]</source>
        <translation>Il terreno più ripido non si taglia [gradi]</translation>
    </message>
    <message>
        <source>Ground that is steeper is not cut.</source>
        <translation>Il terreno che è più ripido non si taglia.</translation>
    </message>
    <message>
        <source>Cut only within this distance of roads, such as 200m</source>
        <translation>Tagliare solo entro questa distanza dalle strade, p. es. 200m</translation>
    </message>
    <message>
        <source>Only ground within this of a road is cut: 200m.</source>
        <translation>Si taglia solo il terreno entro questa distanza da una strada: 200m.</translation>
    </message>
    <message>
        <source>Cut nothing within this distance of roads, such as 50m</source>
        <translation>Non tagliare nulla entro questa distanza dalle strade, p. es. 50m</translation>
    </message>
    <message>
        <source>Ground within this of a road is not cut: 50m.</source>
        <translation>Il terreno entro questa distanza da una strada non si taglia: 50m.</translation>
    </message>
    <message>
        <source>Fire breaks</source>
        <translation>Viali tagliafuoco</translation>
    </message>
    <message>
        <source>Fire breaks as polygons</source>
        <translation>Viali tagliafuoco come poligoni</translation>
    </message>
    <message>
        <source>Segments to build, in order</source>
        <translation>Tratti da costruire, in ordine</translation>
    </message>
    <message>
        <source>Compartments between the breaks</source>
        <translation>Comparti tra i viali tagliafuoco</translation>
    </message>
    <message>
        <source>The plan on one page: map, segments, doubt; opens in any browser</source>
        <translation>Il piano in una pagina: carta, tratti, incertezza; si apre in ogni browser</translation>
    </message>
    <message>
        <source>Cutting priority</source>
        <translation>Priorità di taglio</translation>
    </message>
    <message>
        <source>What each cell would keep of its spread once treated</source>
        <translation>Ciò che ogni cella conserverebbe della sua propagazione una volta trattata</translation>
    </message>
    <message>
        <source>Burn frequency without breaks</source>
        <translation>Frequenza di incendio senza viali</translation>
    </message>
    <message>
        <source>Burn frequency with the breaks</source>
        <translation>Frequenza di incendio con i viali</translation>
    </message>
    <message>
        <source>Existing breaks, what each is worth, and whether it is kept up</source>
        <translation>Viali esistenti, quanto vale ciascuno e se viene mantenuto</translation>
    </message>
    <message>
        <source>What the plan does for its goal and for all others</source>
        <translation>Che cosa fa il piano per il suo scopo e per tutti gli altri</translation>
    </message>
    <message>
        <source>What is built, kept up and burnt in each year</source>
        <translation>Che cosa si costruisce, si mantiene e brucia in ogni anno</translation>
    </message>
    <message>
        <source>Size of every fire without and with the breaks</source>
        <translation>Dimensione di ogni incendio senza e con i viali</translation>
    </message>
    <message>
        <source>Burnt share at every budget</source>
        <translation>Quota bruciata a ogni budget</translation>
    </message>
    <message>
        <source>Cells burnt in every run of it</source>
        <translation>Celle bruciate in ogni sua esecuzione</translation>
    </message>
    <message>
        <source>Burnt share at every budget, without a clock and with perfect breaks</source>
        <translation>Quota bruciata a ogni budget, senza orologio e con viali perfetti</translation>
    </message>
    <message>
        <source>Picture of the plan</source>
        <translation>Immagine del piano</translation>
    </message>
    <message>
        <source>Rank cells</source>
        <translation>Ordinare le celle</translation>
    </message>
    <message>
        <source>Rank the cells of a spread network by the order in which they should be cut: higher is earlier.</source>
        <translation>Ordina le celle di una rete di propagazione secondo quando vanno tagliate: più alto è prima.</translation>
    </message>
    <message>
        <source>Rankings that lay a pattern for the budget give another order for another budget.</source>
        <translation>I metodi che tracciano uno schema per il budget danno un altro ordine per un altro budget.</translation>
    </message>
    <message>
        <source>Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.</source>
        <translation>Otto bande con la probabilità che il fuoco passi verso N, NE, E, SE, S, SO, O e NO.</translation>
    </message>
    <message>
        <source>Elevation, for methods that follow ridges [m].</source>
        <translation>Quota, per metodi che seguono i crinali [m].</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: alike].</source>
        <translation>Con quale probabilità un incendio inizia in ogni cella, rispetto alle altre [altrimenti uguale].</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost".</source>
        <translation>Costo del taglio per ettaro: un raster, poligoni con "Campo con il costo".</translation>
    </message>
    <message>
        <source>Select fire breaks</source>
        <translation>Selezionare viali tagliafuoco</translation>
    </message>
    <message>
        <source>Cut the cells of highest priority, as many as the budget allows.</source>
        <translation>Taglia le celle di priorità più alta, quante il budget ne permette.</translation>
    </message>
    <message>
        <source>Ties are cut by row, then column. A priority that was made for another budget is warned of.</source>
        <translation>A parità si taglia per riga, poi per colonna. Si avvisa di una priorità fatta per un altro budget.</translation>
    </message>
    <message>
        <source>Score by which cells are cut, higher is earlier.</source>
        <translation>Punteggio secondo cui le celle si tagliano, più alto è prima.</translation>
    </message>
    <message>
        <source>Cost per hectare, for budgets of money: a raster, or polygons with "Field with the cost".</source>
        <translation>Costo per ettaro, per budget in denaro: un raster, o poligoni con "Campo con il costo".</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority</source>
        <translation>Prendere un raster che non fu scritto come priorità</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority all the same: its greatest numbers are cut first.</source>
        <translation>Prende comunque un raster che non fu scritto come priorità: i suoi numeri maggiori si tagliano prima.</translation>
    </message>
    <message>
        <source>Segments to build</source>
        <translation>Tratti da costruire</translation>
    </message>
    <message>
        <source>Take fire breaks apart into segments to build, best first.</source>
        <translation>Scompone i viali tagliafuoco in tratti da costruire, prima i migliori.</translation>
    </message>
    <message>
        <source>Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope and cost, and the share of all that the breaks save that it adds.</source>
        <translation>Ogni tratto separa due comparti di combustibile e ha un ordine di costruzione, lunghezza, larghezza, superficie, pendenza media e costo, e la parte che aggiunge a tutto ciò che i viali risparmiano.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Tratti</translation>
    </message>
    <message>
        <source>Stages of construction</source>
        <translation>Fasi di costruzione</translation>
    </message>
    <message>
        <source>Length in kilometres</source>
        <translation>Lunghezza in chilometri</translation>
    </message>
    <message>
        <source>Cells that are cut: 1, all others 0.</source>
        <translation>Celle tagliate: 1, tutte le altre 0.</translation>
    </message>
    <message>
        <source>Ranking; decides between segments that save equally much.</source>
        <translation>Ordinamento; decide tra tratti che risparmiano altrettanto.</translation>
    </message>
    <message>
        <source>Elevation on any grid, for the slopes [m].</source>
        <translation>Quota su qualsiasi griglia, per le pendenze [m].</translation>
    </message>
    <message>
        <source>What of the segments goes into a format with one layer</source>
        <translation>Che cosa dei tratti va in un formato con un solo layer</translation>
    </message>
    <message>
        <source>Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].</source>
        <translation>Layer dei tratti da scrivere: linee mediane o contorni [altrimenti entrambi in .gpkg, in altri le linee].</translation>
    </message>
    <message>
        <source>Their middle lines</source>
        <translation>Le loro linee mediane</translation>
    </message>
    <message>
        <source>Their outlines</source>
        <translation>I loro contorni</translation>
    </message>
    <message>
        <source>Map book for crews</source>
        <translation>Libro di mappe per le squadre</translation>
    </message>
    <message>
        <source>Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, its ends, sizes, slope, cost and treatment, and what it is for.</source>
        <translation>Stampa un piano in PDF: una veduta d'insieme, un elenco dei tratti e una pagina per ciascuno con una mappa a scala tonda, i suoi estremi, le misure, la pendenza, il costo e il trattamento, e a che cosa serve.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the plan were written. Its segments alone do as well, without the vegetation; then the elevation is asked for.</source>
        <translation>Scegliere la cartella in cui sono stati scritti tutti i file del piano. Bastano anche i soli tratti, senza la vegetazione; allora viene chiesta la quota.</translation>
    </message>
    <message>
        <source>Segments with a page</source>
        <translation>Tratti con una pagina</translation>
    </message>
    <message>
        <source>Folder of the run</source>
        <translation>Cartella dell'esecuzione</translation>
    </message>
    <message>
        <source>Into which a plan or a comparison was written with all its files.</source>
        <translation>In cui un piano o un confronto è stato scritto con tutti i suoi file.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titolo</translation>
    </message>
    <message>
        <source>Title of the book [default: what the plan says of itself].</source>
        <translation>Titolo del libro [predefinito: quello che il piano dice di sé].</translation>
    </message>
    <message>
        <source>Date, as it is to be shown</source>
        <translation>Data, come deve apparire</translation>
    </message>
    <message>
        <source>Date of the data or the print, shown as it is given.</source>
        <translation>Data dei dati o della stampa, mostrata come viene data.</translation>
    </message>
    <message>
        <source>Roads to draw: lines or areas of any vector file.</source>
        <translation>Strade da disegnare: linee o aree di qualsiasi file vettoriale.</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw</source>
        <translation>Fiumi e laghi da disegnare</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw: lines or areas.</source>
        <translation>Fiumi e laghi da disegnare: linee o aree.</translation>
    </message>
    <message>
        <source>Most segments that get a page</source>
        <translation>Massimo di tratti con una pagina</translation>
    </message>
    <message>
        <source>Segments that get a page, the first in order of construction; the list names all.</source>
        <translation>Tratti che ricevono una pagina, i primi nell'ordine di costruzione; l'elenco li nomina tutti.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Carta</translation>
    </message>
    <message>
        <source>Size of the paper.</source>
        <translation>Formato della carta.</translation>
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
        <translation>Lettera</translation>
    </message>
    <message>
        <source>as its segments (segments.gpkg)</source>
        <translation>come i suoi tratti (segments.gpkg)</translation>
    </message>
    <message>
        <source>Elevation on any grid, beside segments alone; the folder of a plan has its own.</source>
        <translation>Quota su qualsiasi griglia, se si danno i soli tratti; la cartella di un piano ha la sua.</translation>
    </message>
    <message>
        <source>Shorter segments get no page [m]</source>
        <translation>I tratti più corti non ricevono una pagina [m]</translation>
    </message>
    <message>
        <source>Segments shorter than this have no page of their own [m].</source>
        <translation>I tratti più corti di questo non hanno una pagina propria [m].</translation>
    </message>
    <message>
        <source>Upright pages</source>
        <translation>Pagine verticali</translation>
    </message>
    <message>
        <source>Upright pages, the texts under the map.</source>
        <translation>Pagine verticali, con i testi sotto la mappa.</translation>
    </message>
    <message>
        <source>Map book</source>
        <translation>Libro di mappe</translation>
    </message>
    <message>
        <source>Files for crews</source>
        <translation>File per le squadre</translation>
    </message>
    <message>
        <source>Write segments, breaks or compartments of a plan in the format of a crew.</source>
        <translation>Scrive i tratti, i viali tagliafuoco o i comparti di un piano nel formato di una squadra.</translation>
    </message>
    <message>
        <source>The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, .zip for a Shapefile, .geojson for the web.</source>
        <translation>L'estensione del file lo sceglie: .kml per Google Earth e telefoni, .gpx per apparecchi GPS, .dxf per disegni, .zip per uno Shapefile, .geojson per il web.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Elementi</translation>
    </message>
    <message>
        <source>Segments, breaks or compartments of a plan (.gpkg)</source>
        <translation>Tratti, viali tagliafuoco o comparti di un piano (.gpkg)</translation>
    </message>
    <message>
        <source>The segments.gpkg, breaks.gpkg or compartments.gpkg that a plan wrote.</source>
        <translation>Il segments.gpkg, breaks.gpkg o compartments.gpkg scritto da un piano.</translation>
    </message>
    <message>
        <source>File for the crew</source>
        <translation>File per la squadra</translation>
    </message>
    <message>
        <source>Burn frequency</source>
        <translation>Frequenza di incendio</translation>
    </message>
    <message>
        <source>Let many fires start and tell how often each cell burns.</source>
        <translation>Fa partire molti incendi e dice quanto spesso brucia ogni cella.</translation>
    </message>
    <message>
        <source>Fires with a duration need a network with times. With the same seed the fires are the same with and without breaks, so their difference is the breaks' work alone.</source>
        <translation>Gli incendi con una durata richiedono una rete con tempi. Con lo stesso seme gli incendi sono gli stessi con e senza viali, perciò la differenza è opera dei soli viali.</translation>
    </message>
    <message>
        <source>Mean burnt share</source>
        <translation>Quota bruciata media</translation>
    </message>
    <message>
        <source>Largest burnt share</source>
        <translation>Quota bruciata massima</translation>
    </message>
    <message>
        <source>Mean fire in hectares</source>
        <translation>Incendio medio in ettari</translation>
    </message>
    <message>
        <source>Largest fire in hectares</source>
        <translation>Incendio massimo in ettari</translation>
    </message>
    <message>
        <source>Cut cells: a raster, or own breaks as polygons or lines.</source>
        <translation>Celle tagliate: un raster, o viali propri come poligoni o linee.</translation>
    </message>
    <message>
        <source>Roads, rivers and the like on ground that the network holds as fuel; they stop fire as "How often a barrier holds" says.</source>
        <translation>Strade, fiumi e simili su suolo che la rete ritiene combustibile; fermano il fuoco come dice "Quanto spesso una barriera tiene".</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: until they end by themselves].</source>
        <translation>Quanto durano gli incendi: 8h, un elenco che le esecuzioni prendono a turno (4h,8h), lognormal:8h,0.7 (mediana e sigma), uniform:2h,12h, o weather [altrimenti finché finiscono da sé].</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: always].</source>
        <translation>Quanto spesso un pezzo di viale tiene in un'esecuzione: una quota (0.47 sul campo), flame (per larghezza e intensità del fuoco, Wilson 1988) o flame:flames (1.5 lunghezze di fiamma); i pezzi hanno 400 m, o come in 0.47:800 [altrimenti sempre].</translation>
    </message>
    <message>
        <source>Take "Fire breaks" as lines of this width, such as 12m, or of the width in that column; they may be narrower than a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].</source>
        <translation>Prende "Viali tagliafuoco" come linee di questa larghezza, ad es. 12m, o della larghezza in quella colonna; possono essere più strette di una cella e fermano il fuoco tra le celle che separano [altrimenti le linee prendono ogni cella che toccano].</translation>
    </message>
    <message>
        <source>What treated cells keep of their spread (kept.tif)</source>
        <translation>Ciò che le celle trattate conservano della propagazione (kept.tif)</translation>
    </message>
    <message>
        <source>What each cell keeps of its spread probability once it is treated, in place of one "Share of the spread that a break lets through" for all: kept.tif of a plan with treatments.</source>
        <translation>Ciò che ogni cella conserva della sua probabilità di propagazione una volta trattata, al posto di una sola "Quota della propagazione che un viale lascia passare" per tutte: kept.tif di un piano con trattamenti.</translation>
    </message>
    <message>
        <source>Side of the windows in which a large map is read [cells]</source>
        <translation>Lato delle finestre in cui si legge una carta grande [celle]</translation>
    </message>
    <message>
        <source>Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire needs it, so that maps larger than the memory can burn; the fires are the same.</source>
        <translation>Legge la carta per finestre di questo lato (una potenza di due, ad es. 512) intorno a ogni incendio, più grandi dove un incendio lo richiede, così che possano bruciare carte più grandi della memoria; gli incendi sono gli stessi.</translation>
    </message>
    <message>
        <source>Times for the folder of arrival times, such as 2h,4h</source>
        <translation>Tempi per la cartella dei tempi di arrivo, ad es. 2h,4h</translation>
    </message>
    <message>
        <source>Times for "Folder for arrival times".</source>
        <translation>Tempi per "Cartella per tempi di arrivo".</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes [hectares]</source>
        <translation>Limiti delle classi di dimensione degli incendi [ettari]</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes for "Folder for arrival times", in hectares.</source>
        <translation>Limiti delle classi di dimensione degli incendi per "Cartella per tempi di arrivo", in ettari.</translation>
    </message>
    <message>
        <source>Flame lengths for the folder of arrival times [m]</source>
        <translation>Lunghezze di fiamma per la cartella dei tempi di arrivo [m]</translation>
    </message>
    <message>
        <source>Flame lengths for "Folder for arrival times", in metres; left out if the network knows no heat.</source>
        <translation>Lunghezze di fiamma per "Cartella per tempi di arrivo", in metri; tralasciate se la rete non conosce il calore.</translation>
    </message>
    <message>
        <source>Fire sizes</source>
        <translation>Dimensioni degli incendi</translation>
    </message>
    <message>
        <source>Folder for arrival times, isochrones and more</source>
        <translation>Cartella per tempi di arrivo, isocrone e altro</translation>
    </message>
    <message>
        <source>Judge existing breaks</source>
        <translation>Giudicare viali esistenti</translation>
    </message>
    <message>
        <source>Tell what each existing fire break is worth, and which gap between breaks matters most.</source>
        <translation>Dice quanto vale ogni viale tagliafuoco esistente e quale varco tra i viali conta di più.</translation>
    </message>
    <message>
        <source>The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are the work of that break alone. The same break at random places stands beside it. The network must hold the fuel that lies on the breaks.</source>
        <translation>Gli stessi incendi bruciano con tutti i viali, senza ciascuno di essi e con ogni varco chiuso, perciò le differenze sono opera di quel solo viale. Accanto sta lo stesso viale in luoghi a caso. La rete deve contenere il combustibile che si trova sui viali.</translation>
    </message>
    <message>
        <source>Longest gap that is looked at [m]</source>
        <translation>Varco più lungo che si considera [m]</translation>
    </message>
    <message>
        <source>Length of the longest gap that is looked at, in metres.</source>
        <translation>Lunghezza del varco più lungo che si considera, in metri.</translation>
    </message>
    <message>
        <source>Most gaps that are looked at</source>
        <translation>Numero massimo di varchi che si considerano</translation>
    </message>
    <message>
        <source>Number of gaps looked at, the shortest.</source>
        <translation>Numero di varchi che si considerano, i più corti.</translation>
    </message>
    <message>
        <source>Random places to compare each break with</source>
        <translation>Luoghi a caso con cui confrontare ogni viale</translation>
    </message>
    <message>
        <source>Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.</source>
        <translation>Numero di luoghi a caso in cui si provano anche ogni viale e ogni varco, per confronto; 0 li tralascia.</translation>
    </message>
    <message>
        <source>Breaks with what each is worth, and gaps with what closing them saves</source>
        <translation>Viali con quanto vale ciascuno, e varchi con quanto risparmia chiuderli</translation>
    </message>
    <message>
        <source>What each break is worth</source>
        <translation>Quanto vale ogni viale</translation>
    </message>
    <message>
        <source>What closing each gap saves</source>
        <translation>Quanto risparmia chiudere ogni varco</translation>
    </message>
    <message>
        <source>What stands and what is missing, in words</source>
        <translation>Che cosa c'è e che cosa manca, in parole</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Valutare</translation>
    </message>
    <message>
        <source>Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.</source>
        <translation>Giudica i metodi di ordinamento: media, percentile 90 % e massimo della quota bruciata a ogni budget.</translation>
    </message>
    <message>
        <source>All rankings meet the same fires, and each plan is made for its budget.</source>
        <translation>Tutti i metodi affrontano gli stessi incendi, e ogni piano è fatto per il suo budget.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Metodi</translation>
    </message>
    <message>
        <source>Methods to hold against each other; all rankings are described below.</source>
        <translation>Metodi da confrontare tra loro; tutti quelli di ordinamento sono descritti sotto.</translation>
    </message>
    <message>
        <source>Ranking to test against</source>
        <translation>Metodo contro cui si fa il test</translation>
    </message>
    <message>
        <source>Ranking that the others are tested against.</source>
        <translation>Metodo contro cui si provano gli altri.</translation>
    </message>
    <message>
        <source>Budgets, such as 5%, 10%</source>
        <translation>Più budget, ad es. 5%, 10%</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: 0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</source>
        <translation>Quanto tagliare, separato da virgole: quote del combustibile come 5% o 0.05, o superfici come 20ha [altrimenti da 0 a 0.4 in passi di 0.01; dove ogni budget è bruciato di nuovo, con orologio o viali che cedono, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test statistico</translation>
    </message>
    <message>
        <source>Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.</source>
        <translation>Wilcoxon dei ranghi con segno a coppie, Wilcoxon della somma dei ranghi per esecuzioni indipendenti, o t a coppie.</translation>
    </message>
    <message>
        <source>Wilcoxon's signed-rank test of pairs</source>
        <translation>Test di Wilcoxon dei ranghi con segno, a coppie</translation>
    </message>
    <message>
        <source>Wilcoxon's rank-sum test of independent runs</source>
        <translation>Test di Wilcoxon della somma dei ranghi, esecuzioni indipendenti</translation>
    </message>
    <message>
        <source>Student's t-test of pairs</source>
        <translation>Test t di Student, a coppie</translation>
    </message>
    <message>
        <source>Significance threshold</source>
        <translation>Soglia di significatività</translation>
    </message>
    <message>
        <source>Significance threshold.</source>
        <translation>Soglia di significatività.</translation>
    </message>
    <message>
        <source>Burnt share and significance of every ranking at every budget</source>
        <translation>Quota bruciata e significatività di ogni metodo a ogni budget</translation>
    </message>
    <message>
        <source>Cells burnt in every run, from which each p-value can be found again</source>
        <translation>Celle bruciate in ogni esecuzione, da cui si può ritrovare ogni valore p</translation>
    </message>
    <message>
        <source>Curves of the burnt share</source>
        <translation>Curve della quota bruciata</translation>
    </message>
    <message>
        <source>Curves of the burnt share, to scale</source>
        <translation>Curve della quota bruciata, scalabili</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confrontare</translation>
    </message>
    <message>
        <source>Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with intervals.</source>
        <translation>Confronta piani: superficie bruciata attesa, valore perduto, incendi peggiori ed ettari salvati per ettaro tagliato, con intervalli.</translation>
    </message>
    <message>
        <source>The fires are fresh: no plan was designed with them, and all burn in the same ones.</source>
        <translation>Gli incendi sono nuovi: nessun piano è stato progettato con essi, e tutti bruciano negli stessi.</translation>
    </message>
    <message>
        <source>Lines: walls as wide as a cell and at most 30 m, of which plans are made by default</source>
        <translation>Linee: muri larghi quanto una cella e al massimo 30 m, di cui sono fatti i piani se non si dice altro</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.</source>
        <translation>Quanto tagliare, separato da virgole: quote del combustibile come 5% o 0.05, o superfici come 20ha.</translation>
    </message>
    <message>
        <source>Shares that breaks let through, separated by commas</source>
        <translation>Quote che i viali lasciano passare, separate da virgole</translation>
    </message>
    <message>
        <source>Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.</source>
        <translation>Quote della sua probabilità di propagazione che una cella trattata conserva, separate da virgole; 0 è perfetto.</translation>
    </message>
    <message>
        <source>Fires expected until the breaks have grown back</source>
        <translation>Incendi attesi finché i viali non sono ricresciuti</translation>
    </message>
    <message>
        <source>Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so often when it is held against what they cost.</source>
        <translation>Numero di incendi che incontrano i viali prima che siano ricresciuti; ciò che risparmiano in un incendio conta altrettante volte quando lo si confronta con il loro costo.</translation>
    </message>
    <message>
        <source>The comparison on one page; opens in any browser</source>
        <translation>Il confronto in una pagina; si apre in ogni browser</translation>
    </message>
    <message>
        <source>Every plan at every budget and leak, with intervals</source>
        <translation>Ogni piano a ogni budget e a ogni perdita, con intervalli</translation>
    </message>
    <message>
        <source>Curves of the plans</source>
        <translation>Curve dei piani</translation>
    </message>
    <message>
        <source>Curves of the plans, to scale</source>
        <translation>Curve dei piani, scalabili</translation>
    </message>
    <message>
        <source>What each step of each plan costs and saves</source>
        <translation>Quanto costa e risparmia ogni passo di ogni piano</translation>
    </message>
    <message>
        <source>Saved against paid, and where the next hectare stops paying</source>
        <translation>Il risparmiato contro il pagato, e dove l'ettaro seguente non conviene più</translation>
    </message>
    <message>
        <source>Validate against a scar</source>
        <translation>Validare su un'area bruciata</translation>
    </message>
    <message>
        <source>Hold a simulated fire against the area that burnt, beside fires that know nothing.</source>
        <translation>Confronta un incendio simulato con l'area che è bruciata, accanto a incendi che non sanno nulla.</translation>
    </message>
    <message>
        <source>Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.</source>
        <translation>Per l'incendio simulato e per i modelli nulli (nessuna crescita, uguale distanza nel combustibile, un'ellisse nel vento) si danno l'indice di Sørensen, l'IoU, l'IoU della sola crescita, la dimensione, il punteggio di Brier e l'affidabilità.</translation>
    </message>
    <message>
        <source>Observed hectares</source>
        <translation>Ettari osservati</translation>
    </message>
    <message>
        <source>Simulated hectares</source>
        <translation>Ettari simulati</translation>
    </message>
    <message>
        <source>Area that burnt</source>
        <translation>Area bruciata</translation>
    </message>
    <message>
        <source>Perimeter of the fire as polygons, or a raster above 0 where it burnt.</source>
        <translation>Perimetro dell'incendio come poligoni, o un raster sopra 0 dove è bruciato.</translation>
    </message>
    <message>
        <source>Where the fire was first seen</source>
        <translation>Dove l'incendio fu visto per primo</translation>
    </message>
    <message>
        <source>Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.</source>
        <translation>Dove l'incendio fu visto per primo: punti, o poligoni che già bruciavano (qualsiasi file vettoriale), o un raster.</translation>
    </message>
    <message>
        <source>How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.</source>
        <translation>Quanto a lungo l'incendio si è propagato, ad es. 3h; lognormal:3h,0.5 (mediana, sigma) dove non è noto bene.</translation>
    </message>
    <message>
        <source>Number of simulated fires.</source>
        <translation>Numero di incendi simulati.</translation>
    </message>
    <message>
        <source>Scores of the simulated fire and of the null models</source>
        <translation>Punteggi dell'incendio simulato e dei modelli nulli</translation>
    </message>
    <message>
        <source>How often cells burnt, by the probability forecast</source>
        <translation>Quanto spesso le celle bruciarono, secondo la probabilità prevista</translation>
    </message>
    <message>
        <source>Share of the simulated fires in which each cell burns</source>
        <translation>Quota degli incendi simulati in cui brucia ogni cella</translation>
    </message>
    <message>
        <source>Picture of the simulated fire over the scar, with the reliability</source>
        <translation>Immagine dell'incendio simulato sull'area bruciata, con l'affidabilità</translation>
    </message>
    <message>
        <source>Calibrate on observed fires</source>
        <translation>Calibrare su incendi osservati</translation>
    </message>
    <message>
        <source>Fit the rate of spread, durations and spread probability to the fires of a region.</source>
        <translation>Adatta velocità di propagazione, durate e probabilità di propagazione agli incendi di una regione.</translation>
    </message>
    <message>
        <source>The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in which they burn. More numbers than the fires can tell are refused.</source>
        <translation>Gli incendi sono poligoni o una tabella con le loro dimensioni e, se noti, i loro giorni; il meteo dice i venti in cui bruciano. Si rifiuta di adattare più numeri di quanti gli incendi ne possano dire.</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Incendi</translation>
    </message>
    <message>
        <source>Numbers fitted</source>
        <translation>Numeri adattati</translation>
    </message>
    <message>
        <source>Observed fires with sizes and days</source>
        <translation>Incendi osservati con dimensioni e giorni</translation>
    </message>
    <message>
        <source>Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.</source>
        <translation>Poligoni o una tabella (CSV) degli incendi di una regione, con le loro dimensioni in ettari e, se noti, i loro giorni.</translation>
    </message>
    <message>
        <source>What to fit: rate, duration, p0</source>
        <translation>Che cosa adattare: rate, duration, p0</translation>
    </message>
    <message>
        <source>What to fit: rate, duration and p0, separated by commas [default: rate and duration; of fewer than three scars the rate alone].</source>
        <translation>Che cosa adattare: rate, duration e p0, separati da virgole [altrimenti rate e duration; con meno di tre aree bruciate solo rate].</translation>
    </message>
    <message>
        <source>Smallest fire that counts [hectares]</source>
        <translation>Incendio più piccolo che conta [ettari]</translation>
    </message>
    <message>
        <source>Fires of fewer hectares do not count: small ones are often not mapped.</source>
        <translation>Gli incendi di meno ettari non contano: i piccoli spesso non sono cartografati.</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: everywhere alike].</source>
        <translation>Con quale probabilità un incendio inizia in ogni cella, rispetto alle altre [altrimenti uguale ovunque].</translation>
    </message>
    <message>
        <source>Column with the size in hectares</source>
        <translation>Colonna con la dimensione in ettari</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the size in hectares [default: found by name].</source>
        <translation>Colonna di "Incendi osservati con dimensioni e giorni" con la dimensione in ettari [altrimenti trovata dal nome].</translation>
    </message>
    <message>
        <source>Column with the first day</source>
        <translation>Colonna con il primo giorno</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the first day [default: found by name].</source>
        <translation>Colonna di "Incendi osservati con dimensioni e giorni" con il primo giorno [altrimenti trovata dal nome].</translation>
    </message>
    <message>
        <source>Column with the last day</source>
        <translation>Colonna con l'ultimo giorno</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the last day [default: found by name].</source>
        <translation>Colonna di "Incendi osservati con dimensioni e giorni" con l'ultimo giorno [altrimenti trovata dal nome].</translation>
    </message>
    <message>
        <source>Time of spread on each day of a fire [hours]</source>
        <translation>Tempo di propagazione in ogni giorno di un incendio [ore]</translation>
    </message>
    <message>
        <source>Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.</source>
        <translation>Ore in cui un incendio si propaga in ciascuno dei suoi giorni; un'ipotesi che distingue velocità e durate.</translation>
    </message>
    <message>
        <source>Longest simulated fire, such as 200h</source>
        <translation>Incendio simulato più lungo, ad es. 200h</translation>
    </message>
    <message>
        <source>No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].</source>
        <translation>Nessun incendio si propaga più a lungo [altrimenti tanti giorni interi quanti l'incendio osservato più lungo, o 200h].</translation>
    </message>
    <message>
        <source>Parameter of the spread model that stays as it is, e.g. moisture=0.06; several are separated by ;.</source>
        <translation>Parametro del modello di propagazione che resta com'è, ad es. moisture=0.06; più valori si separano con ;.</translation>
    </message>
    <message>
        <source>Calibration, which other forms take</source>
        <translation>Calibrazione, che altri moduli prendono</translation>
    </message>
    <message>
        <source>What is told of each fire</source>
        <translation>Ciò che si dice di ogni incendio</translation>
    </message>
    <message>
        <source>Report of a run</source>
        <translation>Rapporto di un'esecuzione</translation>
    </message>
    <message>
        <source>Show a plan or a comparison on one page: map, segments, curve, assumptions, files.</source>
        <translation>Mostra un piano o un confronto in una pagina: carta, tratti, curva, ipotesi, file.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the run were written. The page opens in any browser without a network. Its links lead to files beside the page, so write it into that folder.</source>
        <translation>Scegliete la cartella in cui sono stati scritti tutti i file dell'esecuzione. La pagina si apre in ogni browser senza rete. I suoi collegamenti portano a file accanto alla pagina: scrivetela dunque in quella cartella.</translation>
    </message>
    <message>
        <source>The run on one page</source>
        <translation>L'esecuzione in una pagina</translation>
    </message>
    <message>
        <source>{} was not made: there is nothing to put in it.</source>
        <translation>{} non è stato fatto: non c'è nulla da metterci.</translation>
    </message>
    <message>
        <source>Stopped; no output was written.</source>
        <translation>Fermato; nessun risultato è stato scritto.</translation>
    </message>
    <message>
        <source>Report: {} (open it from the Results Viewer)</source>
        <translation>Rapporto: {} (da aprire nel visualizzatore dei risultati)</translation>
    </message>
    <message>
        <source>[not chosen]</source>
        <translation>[non scelto]</translation>
    </message>
    <message>
        <source>{} holds {}; only a GeoPackage can hold {} as well.</source>
        <translation>{} contiene {}; solo un GeoPackage può contenere anche {}.</translation>
    </message>
    <message>
        <source>The layer {} cannot be read as cells of a raster.</source>
        <translation>Il layer {} non si può leggere come celle di un raster.</translation>
    </message>
    <message>
        <source>An extent needs the CRS of the grid; choose it beside the extent (CRS).</source>
        <translation>Un'estensione richiede il SR della griglia; sceglietelo accanto all'estensione (SR).</translation>
    </message>
    <message>
        <source>Making the engine of Firebreak</source>
        <translation>Creazione del motore di Firebreak</translation>
    </message>
    <message>
        <source>firebreak_gis {} is ready.</source>
        <translation>firebreak_gis {} è pronto.</translation>
    </message>
    <message>
        <source>firebreak_gis {} answers: {} ({})</source>
        <translation>firebreak_gis {} risponde: {} ({})</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Motore</translation>
    </message>
    <message>
        <source>Python with firebreak_gis, or the firebreak program</source>
        <translation>Python con firebreak_gis, o il programma firebreak</translation>
    </message>
    <message>
        <source>empty: found by itself</source>
        <translation>vuoto: si trova da sé</translation>
    </message>
    <message>
        <source>Python or program</source>
        <translation>Python o programma</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Make an engine</source>
        <translation>Creare un motore</translation>
    </message>
    <message>
        <source>Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The Python of QGIS is left alone, and an engine made before stays until the new one answers. Nothing is installed until you press the button.</source>
        <translation>Crea un ambiente Python nel vostro profilo di QGIS, circa 900 MB, e vi installa firebreak_gis: dall'indice dei pacchetti (attraverso il proxy di QGIS), o dal percorso di un clone o di un wheel. Il Python di QGIS non viene toccato, e un motore creato prima resta finché il nuovo non risponde. Nulla viene installato finché non premete il pulsante.</translation>
    </message>
    <message>
        <source>empty: the newest of 3.11 to 3.13 found</source>
        <translation>vuoto: il più recente trovato da 3.11 a 3.13</translation>
    </message>
    <message>
        <source>Python to make it from</source>
        <translation>Python con cui crearlo</translation>
    </message>
    <message>
        <source>A name in the index, or the path of a clone or a wheel.</source>
        <translation>Un nome dell'indice, o il percorso di un clone o di un wheel.</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Pacchetto</translation>
    </message>
    <message>
        <source>Make engine</source>
        <translation>Crea motore</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Firebreak settings…</source>
        <translation>Impostazioni di Firebreak…</translation>
    </message>
    <message>
        <source>Firebreak</source>
        <translation>Firebreak</translation>
    </message>
    <message>
        <source>Firebreak (plan forest fire breaks)</source>
        <translation>Firebreak (pianificare viali tagliafuoco nei boschi)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametri</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Risultati</translation>
    </message>
</context>
</TS>
