<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt" sourcelanguage="en">
<context>
    <name>Firebreak</name>
    <message>
        <source>1 Prepare</source>
        <translation>1 Preparar</translation>
    </message>
    <message>
        <source>2 Rank and cut</source>
        <translation>2 Ordenar e cortar</translation>
    </message>
    <message>
        <source>3 Burn</source>
        <translation>3 Queimar</translation>
    </message>
    <message>
        <source>4 Judge</source>
        <translation>4 Avaliar</translation>
    </message>
    <message>
        <source>Align landscape</source>
        <translation>Alinhar a paisagem</translation>
    </message>
    <message>
        <source>Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.</source>
        <translation>Coloca elevação, vegetação e densidade numa grelha quadrada comum em metros, com os códigos traduzidos em classes de combustível.</translation>
    </message>
    <message>
        <source>The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape (.lcp) as elevation holds all layers.</source>
        <translation>As camadas podem ter qualquer SRC, extensão e tamanho de célula; são colocadas numa grelha quadrada em metros. A densidade pode ser um raster, uma palavra para todo o combustível (quão fechado é), ou faltar se a legenda a indicar. Uma paisagem FlamMap (.lcp) como elevação contém todas as camadas.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.</source>
        <translation>Elevação em metros, em qualquer SRC e tamanho de célula; ou um ficheiro de paisagem (.lcp), que contém todas as camadas.</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Vegetação</translation>
    </message>
    <message>
        <source>Codes of the vegetation, explained by the legend.</source>
        <translation>Códigos da vegetação, que a legenda explica.</translation>
    </message>
    <message>
        <source>Vegetation density</source>
        <translation>Densidade da vegetação</translation>
    </message>
    <message>
        <source>Codes of the density of the vegetation; without it the densities come from the legend.</source>
        <translation>Códigos da densidade da vegetação; sem eles as densidades vêm da legenda.</translation>
    </message>
    <message>
        <source>Legend of the vegetation codes</source>
        <translation>Legenda dos códigos de vegetação</translation>
    </message>
    <message>
        <source>What the vegetation codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>O que significam os códigos de vegetação: uma legenda incluída, ou um ficheiro CSV próprio.</translation>
    </message>
    <message>
        <source>Fuel models of Anderson 1982</source>
        <translation>Modelos de combustível de Anderson 1982</translation>
    </message>
    <message>
        <source>Canopy cover in percent as density: below 40 sparse, below 70 normal, else dense</source>
        <translation>Coberto das copas em percentagem como densidade: abaixo de 40 esparso, abaixo de 70 normal, senão denso</translation>
    </message>
    <message>
        <source>CORINE Land Cover, level 3, three-digit codes</source>
        <translation>CORINE Land Cover, nível 3, códigos de três algarismos</translation>
    </message>
    <message>
        <source>CORINE Land Cover as the raster of the European Environment Agency holds it: grid codes 1 to 44 in the order of level 3</source>
        <translation>CORINE Land Cover como raster da Agência Europeia do Ambiente: códigos 1 a 44 pela ordem do nível 3</translation>
    </message>
    <message>
        <source>Vegetation densities of Russo, Russo, Siettos 2016</source>
        <translation>Densidades de vegetação de Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Fuel map of Europe in 12 classes, as the PROPAGATOR fire model uses it</source>
        <translation>Carta de combustíveis da Europa em 12 classes, como a usa o modelo de fogo PROPAGATOR</translation>
    </message>
    <message>
        <source>Fuel types of the Canadian Forest Fire Behavior Prediction System</source>
        <translation>Tipos de combustível do Canadian Forest Fire Behavior Prediction System</translation>
    </message>
    <message>
        <source>Fuel models of Portugal</source>
        <translation>Modelos de combustível de Portugal</translation>
    </message>
    <message>
        <source>Fuel models of the Chilean Kitral system, codes as in Cell2Fire</source>
        <translation>Modelos de combustível do sistema chileno Kitral, códigos como no Cell2Fire</translation>
    </message>
    <message>
        <source>Vegetation types of Russo, Russo, Siettos 2016</source>
        <translation>Tipos de vegetação de Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Vegetation of the PROPAGATOR fire model in 7 classes</source>
        <translation>Vegetação do modelo de fogo PROPAGATOR em 7 classes</translation>
    </message>
    <message>
        <source>Fire behaviour fuel models of Scott and Burgan 2005</source>
        <translation>Modelos de combustível de Scott e Burgan 2005</translation>
    </message>
    <message>
        <source>Tree cover density in percent</source>
        <translation>Densidade do coberto arbóreo em percentagem</translation>
    </message>
    <message>
        <source>ESA WorldCover 10 m, codes of releases 2020 v100 and 2021 v200</source>
        <translation>ESA WorldCover 10 m, códigos das edições 2020 v100 e 2021 v200</translation>
    </message>
    <message>
        <source>as one class for all fuel</source>
        <translation>como uma classe para todo o combustível</translation>
    </message>
    <message>
        <source>Sparse everywhere</source>
        <translation>Esparsa em toda a parte</translation>
    </message>
    <message>
        <source>Normal everywhere</source>
        <translation>Normal em toda a parte</translation>
    </message>
    <message>
        <source>Dense everywhere</source>
        <translation>Densa em toda a parte</translation>
    </message>
    <message>
        <source>As closed as the fuel around each cell is</source>
        <translation>Tão fechada como o combustível à volta de cada célula</translation>
    </message>
    <message>
        <source>as a CSV file</source>
        <translation>como ficheiro CSV</translation>
    </message>
    <message>
        <source>Creation options, such as COMPRESS=ZSTD</source>
        <translation>Opções de criação, p. ex. COMPRESS=ZSTD</translation>
    </message>
    <message>
        <source>Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.</source>
        <translation>Opção de criação do controlador COG do GDAL, p. ex. COMPRESS=ZSTD.</translation>
    </message>
    <message>
        <source>Legend of the density codes</source>
        <translation>Legenda dos códigos de densidade</translation>
    </message>
    <message>
        <source>What the density codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>O que significam os códigos de densidade: uma legenda incluída, ou um ficheiro CSV próprio.</translation>
    </message>
    <message>
        <source>CRS of the grid</source>
        <translation>SRC da grelha</translation>
    </message>
    <message>
        <source>CRS of the grid, projected in metres [default: the "Elevation"'s if it is in metres, else the UTM zone].</source>
        <translation>SRC da grelha, projetado em metros [senão, o de "Elevação" se estiver em metros, ou a zona UTM].</translation>
    </message>
    <message>
        <source>Cell size [m]</source>
        <translation>Tamanho da célula [m]</translation>
    </message>
    <message>
        <source>Cell size [default: the "Elevation"'s].</source>
        <translation>Tamanho da célula [senão, o de "Elevação"].</translation>
    </message>
    <message>
        <source>Extent (needs the CRS of the grid)</source>
        <translation>Extensão (precisa do SRC da grelha)</translation>
    </message>
    <message>
        <source>Extent in the CRS of the grid [default: what all layers cover].</source>
        <translation>Extensão no SRC da grelha [senão, o que todas as camadas cobrem].</translation>
    </message>
    <message>
        <source>Take the grid of this raster</source>
        <translation>Usar a grelha deste raster</translation>
    </message>
    <message>
        <source>Take the grid of this raster.</source>
        <translation>Usa a grelha deste raster.</translation>
    </message>
    <message>
        <source>True CRS of the layers, such as dem=EPSG:32635</source>
        <translation>SRC verdadeiro das camadas, p. ex. dem=EPSG:32635</translation>
    </message>
    <message>
        <source>The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.</source>
        <translation>O SRC verdadeiro de dem, vegetation ou density, ou de todos, onde um ficheiro não diz nenhum ou diz um errado.</translation>
    </message>
    <message>
        <source>No-data values, such as dem=-9999; vegetation=255</source>
        <translation>Valores sem dados, p. ex. dem=-9999; vegetation=255</translation>
    </message>
    <message>
        <source>Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says that all are data; several are separated by ;.</source>
        <translation>Valores que significam sem dados em dem, vegetation ou density, p. ex. dem=-9999,32767; dem=none diz que todos são dados; vários separam-se com ;.</translation>
    </message>
    <message>
        <source>Bands, such as dem=1; vegetation=2</source>
        <translation>Bandas, p. ex. dem=1; vegetation=2</translation>
    </message>
    <message>
        <source>Band to read of dem, vegetation or density.</source>
        <translation>Banda a ler de dem, vegetation ou density.</translation>
    </message>
    <message>
        <source>Codes that the legend does not list</source>
        <translation>Códigos que a legenda não lista</translation>
    </message>
    <message>
        <source>What to do with codes that the legend does not list.</source>
        <translation>O que fazer com códigos que a legenda não lista.</translation>
    </message>
    <message>
        <source>Refuse them</source>
        <translation>Recusá-los</translation>
    </message>
    <message>
        <source>Take them as land without fuel</source>
        <translation>Tomá-los como terreno sem combustível</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of</source>
        <translation>Recusar aquilo de que só se avisaria</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of.</source>
        <translation>Recusa aquilo de que só se avisaria.</translation>
    </message>
    <message>
        <source>Allow network addresses and archives</source>
        <translation>Permitir endereços de rede e arquivos comprimidos</translation>
    </message>
    <message>
        <source>Allow "Elevation", "Vegetation" and "Vegetation density" to be network addresses or in archives.</source>
        <translation>Permite que "Elevação", "Vegetação" e "Densidade da vegetação" sejam endereços de rede ou estejam em arquivos comprimidos.</translation>
    </message>
    <message>
        <source>Most memory to use, such as 4GB</source>
        <translation>Memória máxima, p. ex. 4GB</translation>
    </message>
    <message>
        <source>Refuse work that needs more, e.g. 4GB [default: most of what there is].</source>
        <translation>Recusa trabalho que precise de mais, p. ex. 4GB [senão, a maior parte da que há].</translation>
    </message>
    <message>
        <source>Calibration, or the account (run.json) of an earlier run</source>
        <translation>Calibração, ou registo (run.json) de uma execução anterior</translation>
    </message>
    <message>
        <source>Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.</source>
        <translation>Toma parâmetros de um ficheiro TOML, ou do run.json de uma execução anterior; o que aqui se indica prevalece.</translation>
    </message>
    <message>
        <source>Elevation on the common grid</source>
        <translation>Elevação na grelha comum</translation>
    </message>
    <message>
        <source>Vegetation classes on the common grid</source>
        <translation>Classes de vegetação na grelha comum</translation>
    </message>
    <message>
        <source>Density classes on the common grid</source>
        <translation>Classes de densidade na grelha comum</translation>
    </message>
    <message>
        <source>Effect of the vegetation, where the legend gives numbers in place of classes</source>
        <translation>Efeito da vegetação, onde a legenda dá números em vez de classes</translation>
    </message>
    <message>
        <source>Effect of the density, where the legend gives numbers in place of classes</source>
        <translation>Efeito da densidade, onde a legenda dá números em vez de classes</translation>
    </message>
    <message>
        <source>Rate of spread on flat calm dry ground, where the legend gives it</source>
        <translation>Velocidade de propagação em terreno plano e seco sem vento, onde a legenda a dá</translation>
    </message>
    <message>
        <source>Load of dead fuel, where the legend gives it</source>
        <translation>Carga de combustível morto, onde a legenda a dá</translation>
    </message>
    <message>
        <source>Load of live fuel, where the legend gives it</source>
        <translation>Carga de combustível vivo, onde a legenda a dá</translation>
    </message>
    <message>
        <source>Heat content of the fuel, where the legend gives it</source>
        <translation>Poder calorífico do combustível, onde a legenda o dá</translation>
    </message>
    <message>
        <source>Moisture of the live fuel, where the legend gives it</source>
        <translation>Humidade do combustível vivo, onde a legenda a dá</translation>
    </message>
    <message>
        <source>Account of the run</source>
        <translation>Registo da execução</translation>
    </message>
    <message>
        <source>Folder for all files</source>
        <translation>Pasta para todos os ficheiros</translation>
    </message>
    <message>
        <source>Spread network</source>
        <translation>Rede de propagação</translation>
    </message>
    <message>
        <source>Find how likely fire spreads from each cell to its neighbours.</source>
        <translation>Determina com que probabilidade o fogo passa de cada célula para as vizinhas.</translation>
    </message>
    <message>
        <source>Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). Wind and slope then act on the times; so make a network without times for fires without a duration.</source>
        <translation>As bandas 1 a 8 contêm a probabilidade de o fogo passar para N, NE, E, SE, S, SO, O e NO. Se também se derem os tempos, as bandas 9 a 16 contêm os segundos que isso leva, e a banda 17 o calor que a célula liberta (kJ/m2). O vento e o declive atuam então sobre os tempos; para incêndios sem duração faça, pois, uma rede sem tempos.</translation>
    </message>
    <message>
        <source>Cells with fuel</source>
        <translation>Células com combustível</translation>
    </message>
    <message>
        <source>Spread model</source>
        <translation>Modelo de propagação</translation>
    </message>
    <message>
        <source>How fire gets from a cell to its neighbours; all are described below.</source>
        <translation>Como o fogo chega de uma célula às vizinhas; todos são descritos abaixo.</translation>
    </message>
    <message>
        <source>Alexandridis: cellular automaton of vegetation type, density, slope and wind</source>
        <translation>Alexandridis: autómato celular de tipo de vegetação, densidade, declive e vento</translation>
    </message>
    <message>
        <source>Artificial forest: the probability of catching fire is the fuel of the target cell</source>
        <translation>Floresta artificial: a probabilidade de pegar fogo é o combustível da célula de destino</translation>
    </message>
    <message>
        <source>Raster: your own probabilities, and perhaps travel times, from another fire model</source>
        <translation>Raster: probabilidades próprias, e se houver tempos, de outro modelo de fogo</translation>
    </message>
    <message>
        <source>Wind speed [m/s]</source>
        <translation>Velocidade do vento [m/s]</translation>
    </message>
    <message>
        <source>Wind speed at mid-flame height in m/s, or a raster of it on any grid.</source>
        <translation>Velocidade do vento a meia altura da chama em m/s, ou um raster dela em qualquer grelha.</translation>
    </message>
    <message>
        <source>Wind from [degrees clockwise from north]</source>
        <translation>Vento de [graus no sentido horário a partir do norte]</translation>
    </message>
    <message>
        <source>Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.</source>
        <translation>Direção de onde vem o vento, no sentido horário a partir do norte: 270 é vento de oeste; um número ou um raster.</translation>
    </message>
    <message>
        <source>Tell times too (for fires with a duration)</source>
        <translation>Dar também os tempos (para incêndios com duração)</translation>
    </message>
    <message>
        <source>Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.</source>
        <translation>Dá também quanto tempo o fogo leva de célula a célula (bandas 9 a 16, segundos) e o calor de cada célula.</translation>
    </message>
    <message>
        <source>as a raster</source>
        <translation>como raster</translation>
    </message>
    <message>
        <source>Wind towards east and north, in place of speed and direction [m/s]</source>
        <translation>Vento para leste e norte, em vez de velocidade e direção [m/s]</translation>
    </message>
    <message>
        <source>Components of the wind towards east and north, in place of the two above: rasters on any grid.</source>
        <translation>Componentes do vento para leste e norte, em vez dos dois acima: rasters em qualquer grelha.</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel (8 % is 0.08)</source>
        <translation>Humidade do combustível morto fino (8 % é 0.08)</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.</source>
        <translation>Humidade do combustível morto fino como proporção do seu peso seco (8 % é 0.08 ou 8%), ou um raster dela.</translation>
    </message>
    <message>
        <source>Neighbours that a cell can light</source>
        <translation>Vizinhas que uma célula pode inflamar</translation>
    </message>
    <message>
        <source>Cells to which fire can spread from a cell.</source>
        <translation>Células para que o fogo pode passar a partir de uma célula.</translation>
    </message>
    <message>
        <source>All eight</source>
        <translation>Todas as oito</translation>
    </message>
    <message>
        <source>The four that share a side</source>
        <translation>As quatro que partilham um lado</translation>
    </message>
    <message>
        <source>Parameters of the spread model, such as p0=0.5</source>
        <translation>Parâmetros do modelo de propagação, p. ex. p0=0.5</translation>
    </message>
    <message>
        <source>Parameter of the spread model, e.g. p0=0.5; several are separated by ;.</source>
        <translation>Parâmetro do modelo de propagação, p. ex. p0=0.5; vários separam-se com ;.</translation>
    </message>
    <message>
        <source>File with the probabilities for other tools (.mtx, .npz)</source>
        <translation>Ficheiro com as probabilidades para outros programas (.mtx, .npz)</translation>
    </message>
    <message>
        <source>Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or .graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.</source>
        <translation>Escreve também as probabilidades para outros programas: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) ou .graphml (até 20,000 células com combustível). As células são numeradas linha a linha a partir do canto superior esquerdo.</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; with 8 by 0.002 and 3.4 %. Every command reads such files.</source>
        <translation>Bits por número no ficheiro. Com 16 as probabilidades erram em 8e-6 no máximo, os tempos e o calor em 0.013 %; com 8, em 0.002 e 3.4 %. Todos os comandos leem estes ficheiros.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exato</translation>
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
        <translation>Onde se pode defender uma linha</translation>
    </message>
    <message>
        <source>Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by it.</source>
        <translation>Avalia de 0 a 1 quão bem se pode defender uma linha em cada célula: o que vale a melhor linha ao alcance (cristas, fundos de vale, estradas, rios, bordas do combustível), com o declive para as máquinas e o acesso. Os planos seguem-na.</translation>
    </message>
    <message>
        <source>The weights have no source for your region: they are yours to set.</source>
        <translation>Os pesos não têm fonte para a sua região: cabe-lhe a si defini-los.</translation>
    </message>
    <message>
        <source>Mean suitability where there is fuel</source>
        <translation>Aptidão média onde há combustível</translation>
    </message>
    <message>
        <source>Roads and tracks</source>
        <translation>Estradas e caminhos</translation>
    </message>
    <message>
        <source>Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which crews drive; those that stop fire are barriers too.</source>
        <translation>Estradas e caminhos (linhas ou um raster), junto dos quais as faixas são mais fáceis de construir e defender, e por onde vão as equipas; os que param o fogo são também barreiras.</translation>
    </message>
    <message>
        <source>Rivers and lakes</source>
        <translation>Rios e lagos</translation>
    </message>
    <message>
        <source>Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are barriers too.</source>
        <translation>Rios e lagos (linhas, áreas, um raster), junto dos quais as faixas são mais fáceis de defender; os que param o fogo são também barreiras.</translation>
    </message>
    <message>
        <source>What lines of the ground are worth, such as ridge=0.8; reach=60</source>
        <translation>O que valem as linhas do terreno, p. ex. ridge=0.8; reach=60</translation>
    </message>
    <message>
        <source>What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; several are separated by ;.</source>
        <translation>O que vale uma linha, ou um alcance, p. ex. ridge=0.8, valley=0 ou reach=60; vários separam-se com ;.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines</source>
        <translation>Compartimentos delimitados por linhas de controlo</translation>
    </message>
    <message>
        <source>Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: potential operational delineations (PODs), on which crews agree before a fire.</source>
        <translation>Dividir a paisagem em compartimentos de tamanho semelhante, delimitados pelas linhas mais fáceis de defender: delimitações operacionais potenciais (PODs), que as equipas acordam antes de um incêndio.</translation>
    </message>
    <message>
        <source>Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. The second layer of the file holds the borders.</source>
        <translation>Cada compartimento tem o seu combustível, as suas ignições e valores, o que arde em incêndios simulados e a qualidade do seu limite. A segunda camada do ficheiro contém os limites.</translation>
    </message>
    <message>
        <source>Compartments</source>
        <translation>Compartimentos</translation>
    </message>
    <message>
        <source>Borders in kilometres</source>
        <translation>Limites em quilómetros</translation>
    </message>
    <message>
        <source>Mean suitability of the borders</source>
        <translation>Aptidão média dos limites</translation>
    </message>
    <message>
        <source>Size of the compartments, such as 500ha</source>
        <translation>Tamanho dos compartimentos, p. ex. 500ha</translation>
    </message>
    <message>
        <source>Size of the compartments, hectares of fuel; none is larger than one and a half times this.</source>
        <translation>Tamanho dos compartimentos, em hectares de combustível; nenhum é maior do que uma vez e meia este valor.</translation>
    </message>
    <message>
        <source>Values at risk</source>
        <translation>Valores em risco</translation>
    </message>
    <message>
        <source>Values at risk: a raster, or polygons or points with "Field with the value" [default: 1 on fuel].</source>
        <translation>Valores em risco: um raster, ou polígonos ou pontos com "Campo com o valor" [senão, 1 sobre combustível].</translation>
    </message>
    <message>
        <source>How long fires burn, such as 8h</source>
        <translation>Quanto tempo ardem os incêndios, p. ex. 8h</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: lognormal:8h,0.7, an assumption].</source>
        <translation>Quanto tempo ardem os incêndios: 8h, uma lista que as execuções tomam à vez (4h,8h), lognormal:8h,0.7 (mediana e sigma), uniform:2h,12h, ou weather [senão, lognormal:8h,0.7, um pressuposto].</translation>
    </message>
    <message>
        <source>Ignition points</source>
        <translation>Pontos de ignição</translation>
    </message>
    <message>
        <source>Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of ignition probability [default: one random cell with fuel a run].</source>
        <translation>Pontos, polígonos (perímetros que já ardem; qualquer ficheiro vetorial, ou CSV com x e y) ou um raster da probabilidade de ignição [senão, uma célula ao acaso com combustível por execução].</translation>
    </message>
    <message>
        <source>Number of fires</source>
        <translation>Número de incêndios</translation>
    </message>
    <message>
        <source>Simulated fires.</source>
        <translation>Incêndios simulados.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>Seed of all draws.</source>
        <translation>Semente de todos os sorteios.</translation>
    </message>
    <message>
        <source>How much more the worst ground counts than the best</source>
        <translation>Quanto mais conta o pior terreno do que o melhor</translation>
    </message>
    <message>
        <source>Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.</source>
        <translation>Número de vezes que o pior terreno conta tanto como o melhor, de 1 a 100; com 1 pedem-se os limites mais curtos.</translation>
    </message>
    <message>
        <source>Field with the value</source>
        <translation>Campo com o valor</translation>
    </message>
    <message>
        <source>Column of the value polygons or points [default: 1 for each].</source>
        <translation>Coluna dos polígonos ou pontos de valor [senão, 1 para cada].</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Os valores são</translation>
    </message>
    <message>
        <source>What the numbers of "Values at risk" are: so much in each cell of the raster, polygon or point (people), the sum of which is kept; or so much a hectare.</source>
        <translation>O que são os números de "Valores em risco": tanto em cada célula do raster, polígono ou ponto (pessoas), cuja soma se mantém; ou tanto por hectare.</translation>
    </message>
    <message>
        <source>So much in each cell, polygon or point</source>
        <translation>Tanto em cada célula, polígono ou ponto</translation>
    </message>
    <message>
        <source>So much a hectare</source>
        <translation>Tanto por hectare</translation>
    </message>
    <message>
        <source>Several values at risk, such as people=villages.gpkg,weight=2</source>
        <translation>Vários valores em risco, p. ex. people=villages.gpkg,weight=2</translation>
    </message>
    <message>
        <source>Several values at risk, each as a name and a file, with its field, a weight (what a unit counts in the sum that is planned for) and as=density after it as needed; several are separated by ;, each is told by name.</source>
        <translation>Vários valores em risco, cada um como nome e ficheiro, seguido se preciso do seu campo, um peso (o que uma unidade conta na soma para que se planeia) e as=density; vários separam-se com ;, cada um é dado pelo nome.</translation>
    </message>
    <message>
        <source>Conditions on features, such as barriers=highway = 'primary'</source>
        <translation>Condições sobre elementos, p. ex. barriers=highway = 'primary'</translation>
    </message>
    <message>
        <source>Take only features that fit a condition, with the name of the layer before it, such as barriers=highway = 'primary'; several are separated by ;.</source>
        <translation>Toma só os elementos que cumprem uma condição, com o nome da camada à frente, p. ex. barriers=highway = 'primary'; várias separam-se com ;.</translation>
    </message>
    <message>
        <source>Use of the ignition points</source>
        <translation>Uso dos pontos de ignição</translation>
    </message>
    <message>
        <source>With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or start where such fires of the past are dense.</source>
        <translation>Com pontos ou polígonos: as execuções tomam-nos à vez (a semente sorteia a ordem), começam em todos, ou começam onde tais incêndios do passado são densos.</translation>
    </message>
    <message>
        <source>One for each fire, in turn</source>
        <translation>Um por incêndio, à vez</translation>
    </message>
    <message>
        <source>All at once in every fire</source>
        <translation>Todos ao mesmo tempo em cada incêndio</translation>
    </message>
    <message>
        <source>More fires where they are dense</source>
        <translation>Mais incêndios onde são densos</translation>
    </message>
    <message>
        <source>Ignition points without fuel</source>
        <translation>Pontos de ignição sem combustível</translation>
    </message>
    <message>
        <source>What to do with points and polygons off the landscape or without fuel.</source>
        <translation>O que fazer com pontos e polígonos fora da paisagem ou sem combustível.</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Deixá-los de fora</translation>
    </message>
    <message>
        <source>Column with the hour of each ignition</source>
        <translation>Coluna com a hora de cada ignição</translation>
    </message>
    <message>
        <source>Column of the ignitions that tells when each is lit, in hours after the start of the run.</source>
        <translation>Coluna das ignições que diz quando cada uma começa, em horas após o início da execução.</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Projeções</translation>
    </message>
    <message>
        <source>Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.</source>
        <translation>Projeções que voam à frente do fogo: on, ou números como rate=12,longest=1000 em vez dos pressupostos.</translation>
    </message>
    <message>
        <source>When crews contain a fire, such as 6h</source>
        <translation>Quando os meios contêm um incêndio, p. ex. 6h</translation>
    </message>
    <message>
        <source>When crews contain each fire: a time or a distribution as for "How long fires burn", or a direct attack at such a time, which fails if the fire is too large or too fierce by then: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].</source>
        <translation>Quando os meios contêm cada incêndio: um tempo ou uma distribuição como em "Quanto tempo ardem os incêndios", ou um ataque direto nesse momento, que falha se o fogo já for demasiado grande ou intenso: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha acima) [senão, nunca].</translation>
    </message>
    <message>
        <source>How often a break holds, such as 0.47</source>
        <translation>Com que frequência um aceiro segura o fogo, p. ex. 0.47</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: 0.47, an assumption].</source>
        <translation>Com que frequência um trecho de aceiro segura o fogo numa execução: uma proporção (0.47 no campo), flame (pela largura e intensidade do fogo, Wilson 1988) ou flame:flames (1.5 comprimentos de chama); os trechos têm 400 m, ou como em 0.47:800 [senão, 0.47, um pressuposto].</translation>
    </message>
    <message>
        <source>How often a barrier holds, such as 0.9</source>
        <translation>Com que frequência uma barreira segura o fogo, p. ex. 0.9</translation>
    </message>
    <message>
        <source>Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.</source>
        <translation>Proporção das execuções em que um trecho das barreiras segura o fogo; sorteada à parte dos aceiros.</translation>
    </message>
    <message>
        <source>Stations of crews whom breaks wait for</source>
        <translation>Bases dos meios por que os aceiros esperam</translation>
    </message>
    <message>
        <source>Points or areas that crews set out from: a stretch of break holds only against fire that comes after them [default: crews are everywhere].</source>
        <translation>Pontos ou áreas de onde partem os meios: um trecho de aceiro só segura o fogo que chega depois deles [senão, há meios em toda a parte].</translation>
    </message>
    <message>
        <source>Travel of crews, such as road=40,off=3,delay=10</source>
        <translation>Deslocação dos meios, p. ex. road=40,off=3,delay=10</translation>
    </message>
    <message>
        <source>How they travel: speed on roads and off them in km/h, and minutes from the start of the fire until they leave [default: road=40,off=3,delay=10, assumptions].</source>
        <translation>Como se deslocam: velocidade em estrada e fora dela em km/h, e minutos desde o início do incêndio até partirem [senão, road=40,off=3,delay=10, pressupostos].</translation>
    </message>
    <message>
        <source>Fires without an end by time</source>
        <translation>Incêndios sem fim por tempo</translation>
    </message>
    <message>
        <source>Fires end by themselves and breaks hold in every fire unless "How often a break holds" says otherwise, as in the paper.</source>
        <translation>Os incêndios acabam por si e os aceiros seguram em todos, se "Com que frequência um aceiro segura o fogo" não disser outra coisa, como no artigo.</translation>
    </message>
    <message>
        <source>Table of weather</source>
        <translation>Tabela meteorológica</translation>
    </message>
    <message>
        <source>Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2.</source>
        <translation>Conjunto de situações meteorológicas, de que cada execução tira uma: um ficheiro CSV com wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; ou uma rosa dos ventos como rose:NW=5x0.4,N=8x0.2.</translation>
    </message>
    <message>
        <source>as a wind rose: rose:NW=5x0.4,N=8x0.2</source>
        <translation>como rosa dos ventos: rose:NW=5x0.4,N=8x0.2</translation>
    </message>
    <message>
        <source>Time of each line of the table of weather, such as 1h</source>
        <translation>Duração de cada linha da tabela meteorológica, p. ex. 1h</translation>
    </message>
    <message>
        <source>The lines of the weather follow each other, and each lasts so long, e.g. 1h.</source>
        <translation>As linhas da meteorologia sucedem-se, e cada uma dura tanto, p. ex. 1h.</translation>
    </message>
    <message>
        <source>Columns of the table of weather, such as wind_speed=FF</source>
        <translation>Colunas da tabela meteorológica, p. ex. wind_speed=FF</translation>
    </message>
    <message>
        <source>Name of a column of the weather, e.g. wind_speed=FF; several are separated by ;.</source>
        <translation>Nome de uma coluna da meteorologia, p. ex. wind_speed=FF; vários separam-se com ;.</translation>
    </message>
    <message>
        <source>Units of the table of weather, such as wind_speed=kn</source>
        <translation>Unidades da tabela meteorológica, p. ex. wind_speed=kn</translation>
    </message>
    <message>
        <source>Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; several are separated by ;.</source>
        <translation>Unidade de uma coluna da meteorologia que não a diz, p. ex. wind_speed=kn; várias separam-se com ;.</translation>
    </message>
    <message>
        <source>Columns of the table of weather to leave out</source>
        <translation>Colunas da tabela meteorológica a deixar de fora</translation>
    </message>
    <message>
        <source>Columns of the weather to leave out, separated by commas.</source>
        <translation>Colunas da meteorologia a deixar de fora, separadas por vírgulas.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, and their borders</source>
        <translation>Compartimentos delimitados por linhas de controlo, e os seus limites</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, without outlines</source>
        <translation>Compartimentos delimitados por linhas de controlo, sem contornos</translation>
    </message>
    <message>
        <source>Borders of the compartments, without lines</source>
        <translation>Limites dos compartimentos, sem linhas</translation>
    </message>
    <message>
        <source>Plan fire breaks</source>
        <translation>Planear aceiros</translation>
    </message>
    <message>
        <source>Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and with the breaks.</source>
        <translation>Planeia aceiros e faixas de gestão de combustível a partir de camadas: onde cortar, o que construir primeiro e com que frequência arde cada célula sem e com os aceiros.</translation>
    </message>
    <message>
        <source>Cells cut</source>
        <translation>Células cortadas</translation>
    </message>
    <message>
        <source>Area cut in hectares</source>
        <translation>Área cortada em hectares</translation>
    </message>
    <message>
        <source>Mean burnt share without breaks</source>
        <translation>Proporção ardida média sem aceiros</translation>
    </message>
    <message>
        <source>Mean burnt share with the breaks</source>
        <translation>Proporção ardida média com os aceiros</translation>
    </message>
    <message>
        <source>Area where nothing may be cut</source>
        <translation>Área onde nada pode ser cortado</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.</source>
        <translation>Área (raster ou polígonos; linhas tomam as células que tocam) onde nada pode ser cortado.</translation>
    </message>
    <message>
        <source>Existing barriers</source>
        <translation>Barreiras existentes</translation>
    </message>
    <message>
        <source>Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and cost nothing.</source>
        <translation>Aceiros, estradas e rios existentes (raster, linhas ou polígonos): todas as células que cortam não têm combustível e nada custam.</translation>
    </message>
    <message>
        <source>Budget, such as 10%, 5ha or 20000eur</source>
        <translation>Orçamento, p. ex. 10%, 5ha ou 20000eur</translation>
    </message>
    <message>
        <source>How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or money such as 20000eur, in the currency of the costs.</source>
        <translation>Quanto cortar: uma proporção das células com combustível como 10% ou 0.1, uma área como 5ha, ou dinheiro como 20000eur, na moeda dos custos.</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Método de ordenação</translation>
    </message>
    <message>
        <source>By which cells are ranked; higher is cut earlier. All are described below.</source>
        <translation>Segundo o que se ordenam as células; mais alto corta-se mais cedo. Todos são descritos abaixo.</translation>
    </message>
    <message>
        <source>Betweenness centrality: cells that lie on many fastest routes of fire</source>
        <translation>Centralidade de intermediação: células que ficam em muitos dos trajetos mais rápidos do fogo</translation>
    </message>
    <message>
        <source>Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves</source>
        <translation>Centralidade de Bonacich: células pelas quais o fogo chega a células que são elas próprias fáceis de alcançar</translation>
    </message>
    <message>
        <source>Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere</source>
        <translation>Centralidade de proximidade: células a que o fogo chega cedo de qualquer lado, ou de que chega cedo a qualquer lado</translation>
    </message>
    <message>
        <source>Compartments: a square grid of bands that encloses equal ones</source>
        <translation>Compartimentos: uma malha quadrada de faixas que encerra compartimentos iguais</translation>
    </message>
    <message>
        <source>Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone</source>
        <translation>Intermediação por fluxo de corrente: células por onde passa a propagação por qualquer trajeto, não só pelo mais rápido</translation>
    </message>
    <message>
        <source>Degree: cells that are lit by, or light, their neighbours most</source>
        <translation>Grau: células que mais são inflamadas pelas vizinhas ou mais as inflamam</translation>
    </message>
    <message>
        <source>Defensible fuel profile zones (DFPZ): broad bands along roads and ridges</source>
        <translation>Zonas de combustível defensáveis (DFPZ): faixas largas ao longo de caminhos e cumeadas</translation>
    </message>
    <message>
        <source>Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first</source>
        <translation>Dissecção: muros entre compartimentos por cortes mínimos encaixados, primeiro os que mais poupam pelo seu custo</translation>
    </message>
    <message>
        <source>Dominator: exact gain of cutting one cell, found anew after every few cuts</source>
        <translation>Dominador: ganho exato de cortar uma célula, determinado de novo a cada poucos cortes</translation>
    </message>
    <message>
        <source>DomiRank: cells that dominate their neighbourhood when neighbours compete</source>
        <translation>DomiRank: células que dominam a vizinhança quando as vizinhas competem</translation>
    </message>
    <message>
        <source>Downstream protection value: cells from which most value was lit, found anew after every few cuts</source>
        <translation>Valor de proteção a jusante: células a partir das quais mais valor se inflamou, determinadas de novo a cada poucos cortes</translation>
    </message>
    <message>
        <source>Eigenvector centrality: cells next to the cells that matter most, all in one place of the map</source>
        <translation>Centralidade de vetor próprio: células junto às células que mais importam, todas num só lugar do mapa</translation>
    </message>
    <message>
        <source>Flammability: most flammable cells first, the conventional policy, which looks at each cell alone</source>
        <translation>Inflamabilidade: primeiro as células mais inflamáveis, a prática habitual, que olha cada célula por si</translation>
    </message>
    <message>
        <source>Group betweenness: built cell by cell, each covers fastest routes that the group leaves open</source>
        <translation>Intermediação de grupo: formado célula a célula, cada uma cobre trajetos mais rápidos que o grupo deixa abertos</translation>
    </message>
    <message>
        <source>Influence: cells by way of which fires with a clock take most, found anew after every few cuts on the same draws</source>
        <translation>Influência: células através das quais os incêndios com relógio queimam mais, determinadas de novo após alguns cortes de cada vez com os mesmos sorteios</translation>
    </message>
    <message>
        <source>Information centrality: cells that many parallel ways of spread join closely to all others</source>
        <translation>Centralidade de informação: células que muitas vias paralelas de propagação ligam estreitamente a todas as outras</translation>
    </message>
    <message>
        <source>PageRank: cells that a fire wandering at random from cell to cell is often in</source>
        <translation>PageRank: células em que um fogo que vagueia ao acaso de célula em célula está muitas vezes</translation>
    </message>
    <message>
        <source>Percolation centrality: cells on many fastest routes from where fires start</source>
        <translation>Centralidade de percolação: células em muitos dos trajetos mais rápidos a partir de onde os incêndios começam</translation>
    </message>
    <message>
        <source>Random: cells in random order, the baseline that every plan must beat</source>
        <translation>Acaso: células por ordem aleatória, a referência que qualquer plano tem de superar</translation>
    </message>
    <message>
        <source>Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them</source>
        <translation>Áreas de tratamento colocadas estrategicamente (SPLAT): manchas desencontradas que abrandam o fogo, sem linha reta entre elas</translation>
    </message>
    <message>
        <source>Stripes: parallel bands across a direction, the plainest pattern of practice</source>
        <translation>Faixas: bandas paralelas através de uma direção, o padrão mais simples da prática</translation>
    </message>
    <message>
        <source>Unit of a budget that is a plain number</source>
        <translation>Unidade de um orçamento que é um número simples</translation>
    </message>
    <message>
        <source>What a plain number for "Budget" counts: a share of the fuel, hectares, or money [default: share].</source>
        <translation>O que conta um número simples em "Orçamento": uma proporção do combustível, hectares, ou dinheiro [senão, proporção].</translation>
    </message>
    <message>
        <source>Share of the fuel (0 to 1)</source>
        <translation>Proporção do combustível (0 a 1)</translation>
    </message>
    <message>
        <source>Hectares</source>
        <translation>Hectares</translation>
    </message>
    <message>
        <source>Money</source>
        <translation>Dinheiro</translation>
    </message>
    <message>
        <source>Parameters of the ranking, such as beta=0.5; width=60</source>
        <translation>Parâmetros do método de ordenação, p. ex. beta=0.5; width=60</translation>
    </message>
    <message>
        <source>Parameter of the ranking, e.g. beta=0.5; several are separated by ;.</source>
        <translation>Parâmetro do método de ordenação, p. ex. beta=0.5; vários separam-se com ;.</translation>
    </message>
    <message>
        <source>Share of the spread that a break lets through</source>
        <translation>Proporção da propagação que um aceiro deixa passar</translation>
    </message>
    <message>
        <source>Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.</source>
        <translation>Proporção da sua probabilidade de propagação que uma célula tratada conserva; 0 é um aceiro perfeito, os reais deixam passar.</translation>
    </message>
    <message>
        <source>Least width of the breaks [m]</source>
        <translation>Largura mínima dos aceiros [m]</translation>
    </message>
    <message>
        <source>Least width of the breaks, rounded up to whole cells [default: one cell, or the best for "Share of the spread that a break lets through"].</source>
        <translation>Largura mínima dos aceiros, arredondada para células inteiras [senão, uma célula, ou a melhor para "Proporção da propagação que um aceiro deixa passar"].</translation>
    </message>
    <message>
        <source>Improve the breaks on simulated fires (takes longer)</source>
        <translation>Melhorar os aceiros com incêndios simulados (demora mais)</translation>
    </message>
    <message>
        <source>Improve the breaks by local search on simulated fires; takes longer.</source>
        <translation>Melhora os aceiros por procura local com incêndios simulados; demora mais.</translation>
    </message>
    <message>
        <source>Fires that the plan is made for</source>
        <translation>Incêndios para que o plano é feito</translation>
    </message>
    <message>
        <source>What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).</source>
        <translation>O que deve ser pequeno: a perda do incêndio médio, ou a da pior décima parte dos incêndios (CVaR).</translation>
    </message>
    <message>
        <source>The mean fire</source>
        <translation>O incêndio médio</translation>
    </message>
    <message>
        <source>The worst tenth of the fires</source>
        <translation>A pior décima parte dos incêndios</translation>
    </message>
    <message>
        <source>Width of breaks that are lines [m]</source>
        <translation>Largura dos aceiros que são linhas [m]</translation>
    </message>
    <message>
        <source>Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length times their width. With "How often a break holds" flame, auto is the width with which fires take least. cells cuts whole cells, as in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.</source>
        <translation>Largura das linhas de que são feitos os aceiros, p. ex. 12m, também menor do que uma célula; o orçamento conta o seu comprimento vezes a sua largura. Com "Com que frequência um aceiro segura o fogo" flame, auto é a largura com que os fogos queimam menos. cells corta células inteiras, como no artigo. Predefinição: linhas da largura de uma célula, no máximo 30 m, onde os fogos têm relógio e os aceiros não deixam passar o fogo.</translation>
    </message>
    <message>
        <source>Treatments (CSV, or default)</source>
        <translation>Tratamentos (CSV, ou default)</translation>
    </message>
    <message>
        <source>Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires burn with what they leave [default: all segments alike, by "Share of the spread that a break lets through"].</source>
        <translation>Tabela de tratamentos (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), ou default: cada troço recebe o que mais poupa pelo seu custo, um orçamento em dinheiro é o que eles custam, e os incêndios ardem com o que deixam [senão, todos os troços iguais, segundo "Proporção da propagação que um aceiro deixa passar"].</translation>
    </message>
    <message>
        <source>as a word</source>
        <translation>como palavra</translation>
    </message>
    <message>
        <source>Breaks that stand already</source>
        <translation>Aceiros que já existem</translation>
    </message>
    <message>
        <source>Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.</source>
        <translation>Aceiros que já existem (linhas, polígonos ou um raster do qual cada parte conexa é um): os fogos encontram-nos com e sem o plano, falham como os novos, e o seu combustível volta a crescer se não forem mantidos.</translation>
    </message>
    <message>
        <source>as polygons or lines</source>
        <translation>como polígonos ou linhas</translation>
    </message>
    <message>
        <source>Years of building and upkeep</source>
        <translation>Anos de construção e manutenção</translation>
    </message>
    <message>
        <source>Number of years over which the breaks are built and kept up; 1: all is built at once.</source>
        <translation>Número de anos em que os aceiros são construídos e mantidos; 1: tudo é construído de uma vez.</translation>
    </message>
    <message>
        <source>Budget of each year, such as 500ha</source>
        <translation>Orçamento de cada ano, p. ex. 500ha</translation>
    </message>
    <message>
        <source>What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share [default: what all breaks cost, over the years].</source>
        <translation>O que cada ano permite para manutenção, que se paga primeiro, e construção: 500ha, 20000eur ou uma proporção [senão, o que custam todos os aceiros, pelos anos].</translation>
    </message>
    <message>
        <source>Fires that start in a year</source>
        <translation>Incêndios que começam num ano</translation>
    </message>
    <message>
        <source>Number of fires that start in a year.</source>
        <translation>Número de incêndios que começam num ano.</translation>
    </message>
    <message>
        <source>Discount rate a year, such as 3%</source>
        <translation>Taxa de desconto anual, p. ex. 3%</translation>
    </message>
    <message>
        <source>Rate a year, such as 3%, at which later costs and losses count less.</source>
        <translation>Taxa anual, p. ex. 3%, com que custos e perdas posteriores contam menos.</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back</source>
        <translation>Anos até o combustível tratado voltar a crescer</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "Treatments", or agricultural=3,shrubs=4,pines=4, an assumption].</source>
        <translation>Anos até o combustível tratado voltar a crescer: 4, ou agricultural=3,shrubs=4,pines=8 [senão, os de "Tratamentos", ou agricultural=3,shrubs=4,pines=4, um pressuposto].</translation>
    </message>
    <message>
        <source>Cost of treating anew, as a share of treating first</source>
        <translation>Custo de tratar de novo, como proporção do primeiro tratamento</translation>
    </message>
    <message>
        <source>What treating anew costs, as a share of treating first.</source>
        <translation>O que custa tratar de novo, como proporção do primeiro tratamento.</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare</source>
        <translation>Custo de corte por hectare</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost", or classes such as agricultural=500,shrubs=900,pines=1500.</source>
        <translation>Custo de corte por hectare: um raster, polígonos com "Campo com o custo", ou classes como agricultural=500,shrubs=900,pines=1500.</translation>
    </message>
    <message>
        <source>as classes: agricultural=500,pines=1500</source>
        <translation>como classes: agricultural=500,pines=1500</translation>
    </message>
    <message>
        <source>Field with the cost</source>
        <translation>Campo com o custo</translation>
    </message>
    <message>
        <source>Column of the cost polygons.</source>
        <translation>Coluna dos polígonos de custo.</translation>
    </message>
    <message>
        <source>Cost per hectare where none is known</source>
        <translation>Custo por hectare onde nenhum é conhecido</translation>
    </message>
    <message>
        <source>Cost per hectare where "Cost of cutting per hectare" tells none; alone, everywhere [default: nothing is cut there].</source>
        <translation>Custo por hectare onde "Custo de corte por hectare" não diz nenhum; sozinho, em toda a parte [senão, aí nada se corta].</translation>
    </message>
    <message>
        <source>Area outside of which nothing may be cut</source>
        <translation>Área fora da qual nada pode ser cortado</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.</source>
        <translation>Área (raster ou polígonos; linhas tomam as células que tocam) fora da qual nada pode ser cortado.</translation>
    </message>
    <message>
        <source>Cells that protected and allowed areas keep</source>
        <translation>Células que as áreas protegidas e permitidas conservam</translation>
    </message>
    <message>
        <source>Cells that "Area where nothing may be cut" and "Area outside of which nothing may be cut" keep from being cut: all with a part inside the one or outside the other, or those whose centre is.</source>
        <translation>Células que "Área onde nada pode ser cortado" e "Área fora da qual nada pode ser cortado" livram de corte: todas com uma parte dentro de uma ou fora da outra, ou aquelas cujo centro o está.</translation>
    </message>
    <message>
        <source>Cells with any part in the area</source>
        <translation>Células com alguma parte na área</translation>
    </message>
    <message>
        <source>Cells whose centre is in the area</source>
        <translation>Células cujo centro está na área</translation>
    </message>
    <message>
        <source>Area of interest that is planned for</source>
        <translation>Área de interesse para a qual se planeia</translation>
    </message>
    <message>
        <source>Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start and burn there too.</source>
        <translation>Área de interesse (raster ou polígonos) para a qual se planeia: fora nada é cortado, mas os fogos também começam e ardem aí.</translation>
    </message>
    <message>
        <source>How much more a break counts in bad ground (0: all ground alike)</source>
        <translation>Quanto mais conta uma faixa em mau terreno (0: tudo igual)</translation>
    </message>
    <message>
        <source>How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].</source>
        <translation>Quanto mais conta uma faixa no pior terreno do que numa crista, numa estrada, num rio ou na borda do combustível; 0: todo o terreno igual, como no artigo [por omissão: 1.5 onde o terreno é conhecido e tem relevo].</translation>
    </message>
    <message>
        <source>Steeper ground is not cut [degrees]</source>
        <translation>O terreno mais íngreme não é cortado [graus]</translation>
    </message>
    <message>
        <source>Ground that is steeper is not cut.</source>
        <translation>O terreno que é mais íngreme não é cortado.</translation>
    </message>
    <message>
        <source>Cut only within this distance of roads, such as 200m</source>
        <translation>Cortar só a esta distância de estradas, p. ex. 200m</translation>
    </message>
    <message>
        <source>Only ground within this of a road is cut: 200m.</source>
        <translation>Só é cortado o terreno a esta distância de uma estrada: 200m.</translation>
    </message>
    <message>
        <source>Cut nothing within this distance of roads, such as 50m</source>
        <translation>Nada cortar a esta distância de estradas, p. ex. 50m</translation>
    </message>
    <message>
        <source>Ground within this of a road is not cut: 50m.</source>
        <translation>O terreno a esta distância de uma estrada não é cortado: 50m.</translation>
    </message>
    <message>
        <source>Fire breaks</source>
        <translation>Aceiros</translation>
    </message>
    <message>
        <source>Fire breaks as polygons</source>
        <translation>Aceiros como polígonos</translation>
    </message>
    <message>
        <source>Segments to build, in order</source>
        <translation>Troços a construir, por ordem</translation>
    </message>
    <message>
        <source>Compartments between the breaks</source>
        <translation>Compartimentos entre os aceiros</translation>
    </message>
    <message>
        <source>The plan on one page: map, segments, doubt; opens in any browser</source>
        <translation>O plano numa página: mapa, troços, incerteza; abre em qualquer navegador</translation>
    </message>
    <message>
        <source>Cutting priority</source>
        <translation>Prioridade de corte</translation>
    </message>
    <message>
        <source>What each cell would keep of its spread once treated</source>
        <translation>O que cada célula conservaria da sua propagação depois de tratada</translation>
    </message>
    <message>
        <source>Burn frequency without breaks</source>
        <translation>Frequência de queima sem aceiros</translation>
    </message>
    <message>
        <source>Burn frequency with the breaks</source>
        <translation>Frequência de queima com os aceiros</translation>
    </message>
    <message>
        <source>Existing breaks, what each is worth, and whether it is kept up</source>
        <translation>Aceiros existentes, quanto vale cada um e se é mantido</translation>
    </message>
    <message>
        <source>What the plan does for its goal and for all others</source>
        <translation>O que o plano faz pelo seu objetivo e por todos os outros</translation>
    </message>
    <message>
        <source>What is built, kept up and burnt in each year</source>
        <translation>O que se constrói, se mantém e arde em cada ano</translation>
    </message>
    <message>
        <source>Size of every fire without and with the breaks</source>
        <translation>Tamanho de cada incêndio sem e com os aceiros</translation>
    </message>
    <message>
        <source>Burnt share at every budget</source>
        <translation>Proporção ardida com cada orçamento</translation>
    </message>
    <message>
        <source>Cells burnt in every run of it</source>
        <translation>Células ardidas em cada execução disso</translation>
    </message>
    <message>
        <source>Burnt share at every budget, without a clock and with perfect breaks</source>
        <translation>Proporção ardida com cada orçamento, sem relógio e com aceiros perfeitos</translation>
    </message>
    <message>
        <source>Picture of the plan</source>
        <translation>Imagem do plano</translation>
    </message>
    <message>
        <source>Rank cells</source>
        <translation>Ordenar células</translation>
    </message>
    <message>
        <source>Rank the cells of a spread network by the order in which they should be cut: higher is earlier.</source>
        <translation>Ordena as células de uma rede de propagação pela ordem em que devem ser cortadas: mais alto é mais cedo.</translation>
    </message>
    <message>
        <source>Rankings that lay a pattern for the budget give another order for another budget.</source>
        <translation>Os métodos que traçam um padrão para o orçamento dão outra ordem para outro orçamento.</translation>
    </message>
    <message>
        <source>Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.</source>
        <translation>Oito bandas com a probabilidade de o fogo passar para N, NE, E, SE, S, SO, O e NO.</translation>
    </message>
    <message>
        <source>Elevation, for methods that follow ridges [m].</source>
        <translation>Elevação, para métodos que seguem cumeadas [m].</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: alike].</source>
        <translation>Com que probabilidade um incêndio começa em cada célula, relativamente às outras [senão, igual].</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost".</source>
        <translation>Custo de corte por hectare: um raster, polígonos com "Campo com o custo".</translation>
    </message>
    <message>
        <source>Select fire breaks</source>
        <translation>Selecionar aceiros</translation>
    </message>
    <message>
        <source>Cut the cells of highest priority, as many as the budget allows.</source>
        <translation>Corta as células de maior prioridade, tantas quantas o orçamento permite.</translation>
    </message>
    <message>
        <source>Ties are cut by row, then column. A priority that was made for another budget is warned of.</source>
        <translation>Os empates são cortados por linha, depois por coluna. Avisa-se de uma prioridade feita para outro orçamento.</translation>
    </message>
    <message>
        <source>Score by which cells are cut, higher is earlier.</source>
        <translation>Pontuação segundo a qual as células são cortadas, mais alto é mais cedo.</translation>
    </message>
    <message>
        <source>Cost per hectare, for budgets of money: a raster, or polygons with "Field with the cost".</source>
        <translation>Custo por hectare, para orçamentos em dinheiro: um raster, ou polígonos com "Campo com o custo".</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority</source>
        <translation>Usar um raster que não foi escrito como prioridade</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority all the same: its greatest numbers are cut first.</source>
        <translation>Usa na mesma um raster que não foi escrito como prioridade: os seus números maiores são cortados primeiro.</translation>
    </message>
    <message>
        <source>Segments to build</source>
        <translation>Troços a construir</translation>
    </message>
    <message>
        <source>Take fire breaks apart into segments to build, best first.</source>
        <translation>Decompõe os aceiros em troços a construir, primeiro os melhores.</translation>
    </message>
    <message>
        <source>Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope and cost, and the share of all that the breaks save that it adds.</source>
        <translation>Cada troço separa dois compartimentos de combustível e tem uma ordem de construção, comprimento, largura, área, declive médio e custo, e a parte que acrescenta a tudo o que os aceiros poupam.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Troços</translation>
    </message>
    <message>
        <source>Stages of construction</source>
        <translation>Fases de construção</translation>
    </message>
    <message>
        <source>Length in kilometres</source>
        <translation>Comprimento em quilómetros</translation>
    </message>
    <message>
        <source>Cells that are cut: 1, all others 0.</source>
        <translation>Células cortadas: 1, todas as outras 0.</translation>
    </message>
    <message>
        <source>Ranking; decides between segments that save equally much.</source>
        <translation>Ordenação; decide entre troços que poupam o mesmo.</translation>
    </message>
    <message>
        <source>Elevation on any grid, for the slopes [m].</source>
        <translation>Elevação em qualquer grelha, para os declives [m].</translation>
    </message>
    <message>
        <source>What of the segments goes into a format with one layer</source>
        <translation>O que dos troços vai para um formato de uma só camada</translation>
    </message>
    <message>
        <source>Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].</source>
        <translation>Camada dos troços a escrever: linhas médias ou contornos [senão, ambas em .gpkg, noutros as linhas].</translation>
    </message>
    <message>
        <source>Their middle lines</source>
        <translation>As suas linhas médias</translation>
    </message>
    <message>
        <source>Their outlines</source>
        <translation>Os seus contornos</translation>
    </message>
    <message>
        <source>Map book for crews</source>
        <translation>Livro de mapas para as equipas</translation>
    </message>
    <message>
        <source>Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, its ends, sizes, slope, cost and treatment, and what it is for.</source>
        <translation>Imprime um plano em PDF: uma vista geral, uma lista dos troços e uma página para cada um com um mapa a uma escala redonda, os seus extremos, medidas, declive, custo e tratamento, e para que serve.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the plan were written. Its segments alone do as well, without the vegetation; then the elevation is asked for.</source>
        <translation>Escolha a pasta em que foram escritos todos os ficheiros do plano. Bastam também só os seus troços, sem a vegetação; então é pedida a elevação.</translation>
    </message>
    <message>
        <source>Segments with a page</source>
        <translation>Troços com página</translation>
    </message>
    <message>
        <source>Folder of the run</source>
        <translation>Pasta da execução</translation>
    </message>
    <message>
        <source>Into which a plan or a comparison was written with all its files.</source>
        <translation>Em que um plano ou uma comparação foi escrito com todos os seus ficheiros.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Title of the book [default: what the plan says of itself].</source>
        <translation>Título do livro [predefinição: o que o plano diz de si].</translation>
    </message>
    <message>
        <source>Date, as it is to be shown</source>
        <translation>Data, tal como deve aparecer</translation>
    </message>
    <message>
        <source>Date of the data or the print, shown as it is given.</source>
        <translation>Data dos dados ou da impressão, mostrada tal como é dada.</translation>
    </message>
    <message>
        <source>Roads to draw: lines or areas of any vector file.</source>
        <translation>Estradas a desenhar: linhas ou áreas de qualquer ficheiro vetorial.</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw</source>
        <translation>Rios e lagos a desenhar</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw: lines or areas.</source>
        <translation>Rios e lagos a desenhar: linhas ou áreas.</translation>
    </message>
    <message>
        <source>Most segments that get a page</source>
        <translation>Máximo de troços com página</translation>
    </message>
    <message>
        <source>Segments that get a page, the first in order of construction; the list names all.</source>
        <translation>Troços que recebem uma página, os primeiros na ordem de construção; a lista nomeia todos.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Size of the paper.</source>
        <translation>Formato do papel.</translation>
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
        <translation>como os seus troços (segments.gpkg)</translation>
    </message>
    <message>
        <source>Elevation on any grid, beside segments alone; the folder of a plan has its own.</source>
        <translation>Elevação em qualquer grelha, se só forem dados troços; a pasta de um plano tem a sua.</translation>
    </message>
    <message>
        <source>Shorter segments get no page [m]</source>
        <translation>Troços mais curtos não recebem página [m]</translation>
    </message>
    <message>
        <source>Segments shorter than this have no page of their own [m].</source>
        <translation>Troços mais curtos do que isto não têm página própria [m].</translation>
    </message>
    <message>
        <source>Upright pages</source>
        <translation>Páginas ao alto</translation>
    </message>
    <message>
        <source>Upright pages, the texts under the map.</source>
        <translation>Páginas ao alto, com os textos sob o mapa.</translation>
    </message>
    <message>
        <source>Map book</source>
        <translation>Livro de mapas</translation>
    </message>
    <message>
        <source>Files for crews</source>
        <translation>Ficheiros para as equipas</translation>
    </message>
    <message>
        <source>Write segments, breaks or compartments of a plan in the format of a crew.</source>
        <translation>Escreve os troços, os aceiros ou os compartimentos de um plano no formato de uma equipa.</translation>
    </message>
    <message>
        <source>The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, .zip for a Shapefile, .geojson for the web.</source>
        <translation>A extensão do ficheiro escolhe-o: .kml para o Google Earth e telefones, .gpx para aparelhos GPS, .dxf para desenhos, .zip para um Shapefile, .geojson para a web.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Elementos</translation>
    </message>
    <message>
        <source>Segments, breaks or compartments of a plan (.gpkg)</source>
        <translation>Troços, aceiros ou compartimentos de um plano (.gpkg)</translation>
    </message>
    <message>
        <source>The segments.gpkg, breaks.gpkg or compartments.gpkg that a plan wrote.</source>
        <translation>O segments.gpkg, breaks.gpkg ou compartments.gpkg que um plano escreveu.</translation>
    </message>
    <message>
        <source>File for the crew</source>
        <translation>Ficheiro para a equipa</translation>
    </message>
    <message>
        <source>Burn frequency</source>
        <translation>Frequência de queima</translation>
    </message>
    <message>
        <source>Let many fires start and tell how often each cell burns.</source>
        <translation>Faz começar muitos incêndios e diz com que frequência arde cada célula.</translation>
    </message>
    <message>
        <source>Fires with a duration need a network with times. With the same seed the fires are the same with and without breaks, so their difference is the breaks' work alone.</source>
        <translation>Incêndios com duração precisam de uma rede com tempos. Com a mesma semente os incêndios são os mesmos com e sem aceiros, pelo que a diferença se deve só aos aceiros.</translation>
    </message>
    <message>
        <source>Mean burnt share</source>
        <translation>Proporção ardida média</translation>
    </message>
    <message>
        <source>Largest burnt share</source>
        <translation>Maior proporção ardida</translation>
    </message>
    <message>
        <source>Mean fire in hectares</source>
        <translation>Incêndio médio em hectares</translation>
    </message>
    <message>
        <source>Largest fire in hectares</source>
        <translation>Maior incêndio em hectares</translation>
    </message>
    <message>
        <source>Cut cells: a raster, or own breaks as polygons or lines.</source>
        <translation>Células cortadas: um raster, ou aceiros próprios como polígonos ou linhas.</translation>
    </message>
    <message>
        <source>Roads, rivers and the like on ground that the network holds as fuel; they stop fire as "How often a barrier holds" says.</source>
        <translation>Estradas, rios e semelhantes em terreno que a rede tem como combustível; travam o fogo como "Com que frequência uma barreira segura o fogo" diz.</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: until they end by themselves].</source>
        <translation>Quanto tempo ardem os incêndios: 8h, uma lista que as execuções tomam à vez (4h,8h), lognormal:8h,0.7 (mediana e sigma), uniform:2h,12h, ou weather [senão, até acabarem por si].</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: always].</source>
        <translation>Com que frequência um trecho de aceiro segura o fogo numa execução: uma proporção (0.47 no campo), flame (pela largura e intensidade do fogo, Wilson 1988) ou flame:flames (1.5 comprimentos de chama); os trechos têm 400 m, ou como em 0.47:800 [senão, sempre].</translation>
    </message>
    <message>
        <source>Take "Fire breaks" as lines of this width, such as 12m, or of the width in that column; they may be narrower than a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].</source>
        <translation>Toma "Aceiros" como linhas desta largura, p. ex. 12m, ou da largura nessa coluna; podem ser mais estreitas do que uma célula e travam o fogo entre as células que separam [senão, as linhas tomam cada célula que tocam].</translation>
    </message>
    <message>
        <source>What treated cells keep of their spread (kept.tif)</source>
        <translation>O que as células tratadas conservam da sua propagação (kept.tif)</translation>
    </message>
    <message>
        <source>What each cell keeps of its spread probability once it is treated, in place of one "Share of the spread that a break lets through" for all: kept.tif of a plan with treatments.</source>
        <translation>O que cada célula conserva da sua probabilidade de propagação depois de tratada, em vez de uma só "Proporção da propagação que um aceiro deixa passar" para todas: kept.tif de um plano com tratamentos.</translation>
    </message>
    <message>
        <source>Side of the windows in which a large map is read [cells]</source>
        <translation>Lado das janelas em que um mapa grande é lido [células]</translation>
    </message>
    <message>
        <source>Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire needs it, so that maps larger than the memory can burn; the fires are the same.</source>
        <translation>Lê o mapa por janelas deste lado (uma potência de dois, p. ex. 512) à volta de cada incêndio, maiores onde um incêndio o precisa, para que possam arder mapas maiores do que a memória; os incêndios são os mesmos.</translation>
    </message>
    <message>
        <source>Times for the folder of arrival times, such as 2h,4h</source>
        <translation>Tempos para a pasta de tempos de chegada, p. ex. 2h,4h</translation>
    </message>
    <message>
        <source>Times for "Folder for arrival times".</source>
        <translation>Tempos para "Pasta para tempos de chegada".</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes [hectares]</source>
        <translation>Limites das classes de tamanho de incêndio [hectares]</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes for "Folder for arrival times", in hectares.</source>
        <translation>Limites das classes de tamanho de incêndio para "Pasta para tempos de chegada", em hectares.</translation>
    </message>
    <message>
        <source>Flame lengths for the folder of arrival times [m]</source>
        <translation>Comprimentos de chama para a pasta de tempos de chegada [m]</translation>
    </message>
    <message>
        <source>Flame lengths for "Folder for arrival times", in metres; left out if the network knows no heat.</source>
        <translation>Comprimentos de chama para "Pasta para tempos de chegada", em metros; omitidos se a rede não conhecer o calor.</translation>
    </message>
    <message>
        <source>Fire sizes</source>
        <translation>Tamanhos dos incêndios</translation>
    </message>
    <message>
        <source>Folder for arrival times, isochrones and more</source>
        <translation>Pasta para tempos de chegada, isócronas e mais</translation>
    </message>
    <message>
        <source>Judge existing breaks</source>
        <translation>Avaliar aceiros existentes</translation>
    </message>
    <message>
        <source>Tell what each existing fire break is worth, and which gap between breaks matters most.</source>
        <translation>Diz quanto vale cada aceiro existente e que falha entre aceiros mais importa.</translation>
    </message>
    <message>
        <source>The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are the work of that break alone. The same break at random places stands beside it. The network must hold the fuel that lies on the breaks.</source>
        <translation>Os mesmos incêndios ardem com todos os aceiros, sem cada um deles e com cada falha fechada, pelo que as diferenças se devem só a esse aceiro. Ao lado está o mesmo aceiro em lugares ao acaso. A rede tem de conter o combustível que está sobre os aceiros.</translation>
    </message>
    <message>
        <source>Longest gap that is looked at [m]</source>
        <translation>Falha mais longa que se considera [m]</translation>
    </message>
    <message>
        <source>Length of the longest gap that is looked at, in metres.</source>
        <translation>Comprimento da falha mais longa que se considera, em metros.</translation>
    </message>
    <message>
        <source>Most gaps that are looked at</source>
        <translation>Número máximo de falhas que se consideram</translation>
    </message>
    <message>
        <source>Number of gaps looked at, the shortest.</source>
        <translation>Número de falhas que se consideram, as mais curtas.</translation>
    </message>
    <message>
        <source>Random places to compare each break with</source>
        <translation>Lugares ao acaso com que se compara cada aceiro</translation>
    </message>
    <message>
        <source>Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.</source>
        <translation>Número de lugares ao acaso em que se experimentam também cada aceiro e cada falha, para comparar; 0 deixa-os de fora.</translation>
    </message>
    <message>
        <source>Breaks with what each is worth, and gaps with what closing them saves</source>
        <translation>Aceiros com o que vale cada um, e falhas com o que poupa fechá-las</translation>
    </message>
    <message>
        <source>What each break is worth</source>
        <translation>Quanto vale cada aceiro</translation>
    </message>
    <message>
        <source>What closing each gap saves</source>
        <translation>Quanto poupa fechar cada falha</translation>
    </message>
    <message>
        <source>What stands and what is missing, in words</source>
        <translation>O que está de pé e o que falta, em palavras</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Avaliar métodos</translation>
    </message>
    <message>
        <source>Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.</source>
        <translation>Julga os métodos de ordenação: média, percentil 90 % e máximo da proporção ardida com cada orçamento.</translation>
    </message>
    <message>
        <source>All rankings meet the same fires, and each plan is made for its budget.</source>
        <translation>Todos os métodos enfrentam os mesmos incêndios, e cada plano é feito para o seu orçamento.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Métodos</translation>
    </message>
    <message>
        <source>Methods to hold against each other; all rankings are described below.</source>
        <translation>Métodos a comparar entre si; todos os de ordenação são descritos abaixo.</translation>
    </message>
    <message>
        <source>Ranking to test against</source>
        <translation>Método com que se testa</translation>
    </message>
    <message>
        <source>Ranking that the others are tested against.</source>
        <translation>Método com que os outros são testados.</translation>
    </message>
    <message>
        <source>Budgets, such as 5%, 10%</source>
        <translation>Orçamentos, p. ex. 5%, 10%</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: 0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</source>
        <translation>Quanto cortar, separado por vírgulas: proporções do combustível como 5% ou 0.05, ou áreas como 20ha [senão, de 0 a 0.4 em passos de 0.01; onde cada orçamento é queimado de novo, com relógio ou aceiros que falham, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Teste</translation>
    </message>
    <message>
        <source>Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.</source>
        <translation>Wilcoxon de postos com sinal por pares, Wilcoxon da soma de postos para execuções independentes, ou t por pares.</translation>
    </message>
    <message>
        <source>Wilcoxon's signed-rank test of pairs</source>
        <translation>Teste de Wilcoxon de postos com sinal, por pares</translation>
    </message>
    <message>
        <source>Wilcoxon's rank-sum test of independent runs</source>
        <translation>Teste de Wilcoxon da soma de postos, execuções independentes</translation>
    </message>
    <message>
        <source>Student's t-test of pairs</source>
        <translation>Teste t de Student, por pares</translation>
    </message>
    <message>
        <source>Significance threshold</source>
        <translation>Limiar de significância</translation>
    </message>
    <message>
        <source>Significance threshold.</source>
        <translation>Limiar de significância.</translation>
    </message>
    <message>
        <source>Burnt share and significance of every ranking at every budget</source>
        <translation>Proporção ardida e significância de cada método com cada orçamento</translation>
    </message>
    <message>
        <source>Cells burnt in every run, from which each p-value can be found again</source>
        <translation>Células ardidas em cada execução, com que cada valor p se pode reencontrar</translation>
    </message>
    <message>
        <source>Curves of the burnt share</source>
        <translation>Curvas da proporção ardida</translation>
    </message>
    <message>
        <source>Curves of the burnt share, to scale</source>
        <translation>Curvas da proporção ardida, escaláveis</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with intervals.</source>
        <translation>Compara planos: área ardida esperada, valor perdido, piores incêndios e hectares salvos por hectare cortado, com intervalos.</translation>
    </message>
    <message>
        <source>The fires are fresh: no plan was designed with them, and all burn in the same ones.</source>
        <translation>Os incêndios são novos: nenhum plano foi desenhado com eles, e todos ardem nos mesmos.</translation>
    </message>
    <message>
        <source>Lines: walls as wide as a cell and at most 30 m, of which plans are made by default</source>
        <translation>Linhas: muros da largura de uma célula e no máximo 30 m, de que são feitos os planos por predefinição</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.</source>
        <translation>Quanto cortar, separado por vírgulas: proporções do combustível como 5% ou 0.05, ou áreas como 20ha.</translation>
    </message>
    <message>
        <source>Shares that breaks let through, separated by commas</source>
        <translation>Proporções que os aceiros deixam passar, separadas por vírgulas</translation>
    </message>
    <message>
        <source>Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.</source>
        <translation>Proporções da sua probabilidade de propagação que uma célula tratada conserva, separadas por vírgulas; 0 é perfeito.</translation>
    </message>
    <message>
        <source>Fires expected until the breaks have grown back</source>
        <translation>Incêndios esperados até os aceiros voltarem a crescer</translation>
    </message>
    <message>
        <source>Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so often when it is held against what they cost.</source>
        <translation>Número de incêndios que encontram os aceiros antes de voltarem a crescer; o que poupam num incêndio conta outras tantas vezes quando se compara com o que custam.</translation>
    </message>
    <message>
        <source>The comparison on one page; opens in any browser</source>
        <translation>A comparação numa página; abre em qualquer navegador</translation>
    </message>
    <message>
        <source>Every plan at every budget and leak, with intervals</source>
        <translation>Cada plano com cada orçamento e cada fuga, com intervalos</translation>
    </message>
    <message>
        <source>Curves of the plans</source>
        <translation>Curvas dos planos</translation>
    </message>
    <message>
        <source>Curves of the plans, to scale</source>
        <translation>Curvas dos planos, escaláveis</translation>
    </message>
    <message>
        <source>What each step of each plan costs and saves</source>
        <translation>O que custa e poupa cada passo de cada plano</translation>
    </message>
    <message>
        <source>Saved against paid, and where the next hectare stops paying</source>
        <translation>O poupado face ao pago, e onde o hectare seguinte deixa de compensar</translation>
    </message>
    <message>
        <source>Validate against a scar</source>
        <translation>Validar com uma área ardida</translation>
    </message>
    <message>
        <source>Hold a simulated fire against the area that burnt, beside fires that know nothing.</source>
        <translation>Compara um incêndio simulado com a área que ardeu, ao lado de incêndios que nada sabem.</translation>
    </message>
    <message>
        <source>Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.</source>
        <translation>Para o incêndio simulado e para os modelos nulos (sem crescimento, igual distância no combustível, uma elipse no vento) dão-se o índice de Sørensen, o IoU, o IoU só do crescimento, o tamanho, a pontuação de Brier e a fiabilidade.</translation>
    </message>
    <message>
        <source>Observed hectares</source>
        <translation>Hectares observados</translation>
    </message>
    <message>
        <source>Simulated hectares</source>
        <translation>Hectares simulados</translation>
    </message>
    <message>
        <source>Area that burnt</source>
        <translation>Área ardida</translation>
    </message>
    <message>
        <source>Perimeter of the fire as polygons, or a raster above 0 where it burnt.</source>
        <translation>Perímetro do incêndio como polígonos, ou um raster acima de 0 onde ardeu.</translation>
    </message>
    <message>
        <source>Where the fire was first seen</source>
        <translation>Onde o incêndio foi visto primeiro</translation>
    </message>
    <message>
        <source>Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.</source>
        <translation>Onde o incêndio foi visto primeiro: pontos, ou polígonos que já ardiam (qualquer ficheiro vetorial), ou um raster.</translation>
    </message>
    <message>
        <source>How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.</source>
        <translation>Quanto tempo o incêndio se propagou, p. ex. 3h; lognormal:3h,0.5 (mediana, sigma) onde não se sabe bem.</translation>
    </message>
    <message>
        <source>Number of simulated fires.</source>
        <translation>Número de incêndios simulados.</translation>
    </message>
    <message>
        <source>Scores of the simulated fire and of the null models</source>
        <translation>Pontuações do incêndio simulado e dos modelos nulos</translation>
    </message>
    <message>
        <source>How often cells burnt, by the probability forecast</source>
        <translation>Com que frequência as células arderam, segundo a probabilidade prevista</translation>
    </message>
    <message>
        <source>Share of the simulated fires in which each cell burns</source>
        <translation>Proporção dos incêndios simulados em que cada célula arde</translation>
    </message>
    <message>
        <source>Picture of the simulated fire over the scar, with the reliability</source>
        <translation>Imagem do incêndio simulado sobre a área ardida, com a fiabilidade</translation>
    </message>
    <message>
        <source>Calibrate on observed fires</source>
        <translation>Calibrar com incêndios observados</translation>
    </message>
    <message>
        <source>Fit the rate of spread, durations and spread probability to the fires of a region.</source>
        <translation>Ajusta a velocidade de propagação, as durações e a probabilidade de propagação aos incêndios de uma região.</translation>
    </message>
    <message>
        <source>The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in which they burn. More numbers than the fires can tell are refused.</source>
        <translation>Os incêndios são polígonos ou uma tabela com os tamanhos e, se conhecidos, os dias; a meteorologia diz os ventos em que ardem. Recusa-se ajustar mais números do que os incêndios permitem.</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Incêndios</translation>
    </message>
    <message>
        <source>Numbers fitted</source>
        <translation>Números ajustados</translation>
    </message>
    <message>
        <source>Observed fires with sizes and days</source>
        <translation>Incêndios observados com tamanhos e dias</translation>
    </message>
    <message>
        <source>Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.</source>
        <translation>Polígonos ou uma tabela (CSV) dos incêndios de uma região, com os tamanhos em hectares e, se conhecidos, os dias.</translation>
    </message>
    <message>
        <source>What to fit: rate, duration, p0</source>
        <translation>O que ajustar: rate, duration, p0</translation>
    </message>
    <message>
        <source>What to fit: rate, duration and p0, separated by commas [default: rate and duration; of fewer than three scars the rate alone].</source>
        <translation>O que ajustar: rate, duration e p0, separados por vírgulas [senão, rate e duration; com menos de três áreas ardidas só rate].</translation>
    </message>
    <message>
        <source>Smallest fire that counts [hectares]</source>
        <translation>Menor incêndio que conta [hectares]</translation>
    </message>
    <message>
        <source>Fires of fewer hectares do not count: small ones are often not mapped.</source>
        <translation>Incêndios de menos hectares não contam: os pequenos muitas vezes não estão cartografados.</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: everywhere alike].</source>
        <translation>Com que probabilidade um incêndio começa em cada célula, relativamente às outras [senão, igual em toda a parte].</translation>
    </message>
    <message>
        <source>Column with the size in hectares</source>
        <translation>Coluna com o tamanho em hectares</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the size in hectares [default: found by name].</source>
        <translation>Coluna de "Incêndios observados com tamanhos e dias" com o tamanho em hectares [senão, encontrada pelo nome].</translation>
    </message>
    <message>
        <source>Column with the first day</source>
        <translation>Coluna com o primeiro dia</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the first day [default: found by name].</source>
        <translation>Coluna de "Incêndios observados com tamanhos e dias" com o primeiro dia [senão, encontrada pelo nome].</translation>
    </message>
    <message>
        <source>Column with the last day</source>
        <translation>Coluna com o último dia</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the last day [default: found by name].</source>
        <translation>Coluna de "Incêndios observados com tamanhos e dias" com o último dia [senão, encontrada pelo nome].</translation>
    </message>
    <message>
        <source>Time of spread on each day of a fire [hours]</source>
        <translation>Tempo de propagação em cada dia de um incêndio [horas]</translation>
    </message>
    <message>
        <source>Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.</source>
        <translation>Horas que um incêndio se propaga em cada um dos seus dias; um pressuposto que distingue velocidades de durações.</translation>
    </message>
    <message>
        <source>Longest simulated fire, such as 200h</source>
        <translation>Incêndio simulado mais longo, p. ex. 200h</translation>
    </message>
    <message>
        <source>No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].</source>
        <translation>Nenhum incêndio se propaga mais tempo [senão, tantos dias inteiros como o incêndio observado mais longo, ou 200h].</translation>
    </message>
    <message>
        <source>Parameter of the spread model that stays as it is, e.g. moisture=0.06; several are separated by ;.</source>
        <translation>Parâmetro do modelo de propagação que fica como está, p. ex. moisture=0.06; vários separam-se com ;.</translation>
    </message>
    <message>
        <source>Calibration, which other forms take</source>
        <translation>Calibração, que outros formulários usam</translation>
    </message>
    <message>
        <source>What is told of each fire</source>
        <translation>O que se diz de cada incêndio</translation>
    </message>
    <message>
        <source>Report of a run</source>
        <translation>Relatório de uma execução</translation>
    </message>
    <message>
        <source>Show a plan or a comparison on one page: map, segments, curve, assumptions, files.</source>
        <translation>Mostra um plano ou uma comparação numa página: mapa, troços, curva, pressupostos, ficheiros.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the run were written. The page opens in any browser without a network. Its links lead to files beside the page, so write it into that folder.</source>
        <translation>Escolha a pasta em que foram escritos todos os ficheiros da execução. A página abre em qualquer navegador sem rede. As suas ligações levam a ficheiros ao lado da página; escreva-a, pois, nessa pasta.</translation>
    </message>
    <message>
        <source>The run on one page</source>
        <translation>A execução numa página</translation>
    </message>
    <message>
        <source>{} was not made: there is nothing to put in it.</source>
        <translation>{} não foi feito: não há nada para lá pôr.</translation>
    </message>
    <message>
        <source>Stopped; no output was written.</source>
        <translation>Parado; nenhuma saída foi escrita.</translation>
    </message>
    <message>
        <source>Report: {} (open it from the Results Viewer)</source>
        <translation>Relatório: {} (abra-o no visualizador de resultados)</translation>
    </message>
    <message>
        <source>[not chosen]</source>
        <translation>[não escolhido]</translation>
    </message>
    <message>
        <source>{} holds {}; only a GeoPackage can hold {} as well.</source>
        <translation>{} contém {}; só um GeoPackage pode conter também {}.</translation>
    </message>
    <message>
        <source>The layer {} cannot be read as cells of a raster.</source>
        <translation>A camada {} não pode ser lida como células de um raster.</translation>
    </message>
    <message>
        <source>An extent needs the CRS of the grid; choose it beside the extent (CRS).</source>
        <translation>Uma extensão precisa do SRC da grelha; escolha-o junto da extensão (SRC).</translation>
    </message>
    <message>
        <source>Making the engine of Firebreak</source>
        <translation>A criar o motor do Firebreak</translation>
    </message>
    <message>
        <source>firebreak_gis {} is ready.</source>
        <translation>firebreak_gis {} está pronto.</translation>
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
        <translation>Python com firebreak_gis, ou o programa firebreak</translation>
    </message>
    <message>
        <source>empty: found by itself</source>
        <translation>vazio: encontra-se sozinho</translation>
    </message>
    <message>
        <source>Python or program</source>
        <translation>Python ou programa</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>Make an engine</source>
        <translation>Criar um motor</translation>
    </message>
    <message>
        <source>Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The Python of QGIS is left alone, and an engine made before stays until the new one answers. Nothing is installed until you press the button.</source>
        <translation>Cria um ambiente Python no seu perfil do QGIS, cerca de 900 MB, e instala nele o firebreak_gis: do índice de pacotes (pelo proxy do QGIS), ou do caminho de um clone ou de um wheel. O Python do QGIS fica intacto, e um motor criado antes fica até o novo responder. Nada é instalado antes de premir o botão.</translation>
    </message>
    <message>
        <source>empty: the newest of 3.11 to 3.13 found</source>
        <translation>vazio: o mais novo encontrado de 3.11 a 3.13</translation>
    </message>
    <message>
        <source>Python to make it from</source>
        <translation>Python com que se cria</translation>
    </message>
    <message>
        <source>A name in the index, or the path of a clone or a wheel.</source>
        <translation>Um nome do índice, ou o caminho de um clone ou de um wheel.</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Pacote</translation>
    </message>
    <message>
        <source>Make engine</source>
        <translation>Criar motor</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Firebreak settings…</source>
        <translation>Definições do Firebreak…</translation>
    </message>
    <message>
        <source>Firebreak</source>
        <translation>Firebreak</translation>
    </message>
    <message>
        <source>Firebreak (plan forest fire breaks)</source>
        <translation>Firebreak (planear aceiros florestais)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parâmetros</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Saídas</translation>
    </message>
</context>
</TS>
