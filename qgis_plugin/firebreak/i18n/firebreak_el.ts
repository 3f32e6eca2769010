<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="el" sourcelanguage="en">
<context>
    <name>Firebreak</name>
    <message>
        <source>1 Prepare</source>
        <translation>1 Προετοιμασία</translation>
    </message>
    <message>
        <source>2 Rank and cut</source>
        <translation>2 Κατάταξη και κοπή</translation>
    </message>
    <message>
        <source>3 Burn</source>
        <translation>3 Καύση</translation>
    </message>
    <message>
        <source>4 Judge</source>
        <translation>4 Αξιολόγηση</translation>
    </message>
    <message>
        <source>Align landscape</source>
        <translation>Ευθυγράμμιση τοπίου</translation>
    </message>
    <message>
        <source>Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.</source>
        <translation>Τοποθετεί υψόμετρο, βλάστηση και πυκνότητα σε έναν κοινό τετραγωνικό κάνναβο σε μέτρα, με τους κωδικούς μεταφρασμένους σε κλάσεις καύσιμης ύλης.</translation>
    </message>
    <message>
        <source>The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape (.lcp) as elevation holds all layers.</source>
        <translation>Τα επίπεδα μπορούν να έχουν οποιοδήποτε ΣΑΣ, έκταση και μέγεθος κελιού· τοποθετούνται σε έναν τετραγωνικό κάνναβο σε μέτρα. Η πυκνότητα μπορεί να είναι ψηφιδωτό, μία λέξη για όλη την καύσιμη ύλη (πόσο κλειστή είναι), ή να λείπει αν τη δίνει το υπόμνημα. Ένα τοπίο FlamMap (.lcp) ως υψόμετρο περιέχει όλα τα επίπεδα.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Υψόμετρο</translation>
    </message>
    <message>
        <source>Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.</source>
        <translation>Υψόμετρο σε μέτρα, σε οποιοδήποτε ΣΑΣ και μέγεθος κελιού· ή αρχείο τοπίου (.lcp), που περιέχει όλα τα επίπεδα.</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Βλάστηση</translation>
    </message>
    <message>
        <source>Codes of the vegetation, explained by the legend.</source>
        <translation>Κωδικοί της βλάστησης, που εξηγεί το υπόμνημα.</translation>
    </message>
    <message>
        <source>Vegetation density</source>
        <translation>Πυκνότητα βλάστησης</translation>
    </message>
    <message>
        <source>Codes of the density of the vegetation; without it the densities come from the legend.</source>
        <translation>Κωδικοί της πυκνότητας της βλάστησης· χωρίς αυτούς οι πυκνότητες έρχονται από το υπόμνημα.</translation>
    </message>
    <message>
        <source>Legend of the vegetation codes</source>
        <translation>Υπόμνημα των κωδικών βλάστησης</translation>
    </message>
    <message>
        <source>What the vegetation codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Τι σημαίνουν οι κωδικοί βλάστησης: ενσωματωμένο υπόμνημα, ή δικό σας αρχείο CSV.</translation>
    </message>
    <message>
        <source>Fuel models of Anderson 1982</source>
        <translation>Μοντέλα καύσιμης ύλης του Anderson 1982</translation>
    </message>
    <message>
        <source>Canopy cover in percent as density: below 40 sparse, below 70 normal, else dense</source>
        <translation>Κάλυψη κόμης σε ποσοστό ως πυκνότητα: κάτω από 40 αραιή, κάτω από 70 κανονική, αλλιώς πυκνή</translation>
    </message>
    <message>
        <source>CORINE Land Cover, level 3, three-digit codes</source>
        <translation>CORINE Land Cover, επίπεδο 3, τριψήφιοι κωδικοί</translation>
    </message>
    <message>
        <source>CORINE Land Cover as the raster of the European Environment Agency holds it: grid codes 1 to 44 in the order of level 3</source>
        <translation>CORINE Land Cover ως ψηφιδωτό του Ευρωπαϊκού Οργανισμού Περιβάλλοντος: κωδικοί 1 έως 44 με τη σειρά του επιπέδου 3</translation>
    </message>
    <message>
        <source>Vegetation densities of Russo, Russo, Siettos 2016</source>
        <translation>Πυκνότητες βλάστησης των Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Fuel map of Europe in 12 classes, as the PROPAGATOR fire model uses it</source>
        <translation>Χάρτης καύσιμης ύλης της Ευρώπης σε 12 κλάσεις, όπως τον χρησιμοποιεί το μοντέλο πυρκαγιάς PROPAGATOR</translation>
    </message>
    <message>
        <source>Fuel types of the Canadian Forest Fire Behavior Prediction System</source>
        <translation>Τύποι καύσιμης ύλης του Canadian Forest Fire Behavior Prediction System</translation>
    </message>
    <message>
        <source>Fuel models of Portugal</source>
        <translation>Μοντέλα καύσιμης ύλης της Πορτογαλίας</translation>
    </message>
    <message>
        <source>Fuel models of the Chilean Kitral system, codes as in Cell2Fire</source>
        <translation>Μοντέλα καύσιμης ύλης του χιλιανού συστήματος Kitral, κωδικοί όπως στο Cell2Fire</translation>
    </message>
    <message>
        <source>Vegetation types of Russo, Russo, Siettos 2016</source>
        <translation>Τύποι βλάστησης των Russo, Russo, Siettos 2016</translation>
    </message>
    <message>
        <source>Vegetation of the PROPAGATOR fire model in 7 classes</source>
        <translation>Βλάστηση του μοντέλου πυρκαγιάς PROPAGATOR σε 7 κλάσεις</translation>
    </message>
    <message>
        <source>Fire behaviour fuel models of Scott and Burgan 2005</source>
        <translation>Μοντέλα καύσιμης ύλης των Scott και Burgan 2005</translation>
    </message>
    <message>
        <source>Tree cover density in percent</source>
        <translation>Πυκνότητα δενδροκάλυψης σε ποσοστό</translation>
    </message>
    <message>
        <source>ESA WorldCover 10 m, codes of releases 2020 v100 and 2021 v200</source>
        <translation>ESA WorldCover 10 m, κωδικοί των εκδόσεων 2020 v100 και 2021 v200</translation>
    </message>
    <message>
        <source>as one class for all fuel</source>
        <translation>ως μία κλάση για όλη την καύσιμη ύλη</translation>
    </message>
    <message>
        <source>Sparse everywhere</source>
        <translation>Αραιή παντού</translation>
    </message>
    <message>
        <source>Normal everywhere</source>
        <translation>Κανονική παντού</translation>
    </message>
    <message>
        <source>Dense everywhere</source>
        <translation>Πυκνή παντού</translation>
    </message>
    <message>
        <source>As closed as the fuel around each cell is</source>
        <translation>Τόσο κλειστή όσο η καύσιμη ύλη γύρω από κάθε κελί</translation>
    </message>
    <message>
        <source>as a CSV file</source>
        <translation>ως αρχείο CSV</translation>
    </message>
    <message>
        <source>Creation options, such as COMPRESS=ZSTD</source>
        <translation>Επιλογές δημιουργίας, π.χ. COMPRESS=ZSTD</translation>
    </message>
    <message>
        <source>Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.</source>
        <translation>Επιλογή δημιουργίας του οδηγού COG της GDAL, π.χ. COMPRESS=ZSTD.</translation>
    </message>
    <message>
        <source>Legend of the density codes</source>
        <translation>Υπόμνημα των κωδικών πυκνότητας</translation>
    </message>
    <message>
        <source>What the density codes mean: a built-in legend, or a CSV file of your own.</source>
        <translation>Τι σημαίνουν οι κωδικοί πυκνότητας: ενσωματωμένο υπόμνημα, ή δικό σας αρχείο CSV.</translation>
    </message>
    <message>
        <source>CRS of the grid</source>
        <translation>ΣΑΣ του καννάβου</translation>
    </message>
    <message>
        <source>CRS of the grid, projected in metres [default: the "Elevation"'s if it is in metres, else the UTM zone].</source>
        <translation>ΣΑΣ του καννάβου, προβολικό σε μέτρα [αλλιώς εκείνο του "Υψόμετρο" αν είναι σε μέτρα, ή η ζώνη UTM].</translation>
    </message>
    <message>
        <source>Cell size [m]</source>
        <translation>Μέγεθος κελιού [m]</translation>
    </message>
    <message>
        <source>Cell size [default: the "Elevation"'s].</source>
        <translation>Μέγεθος κελιού [αλλιώς εκείνο του "Υψόμετρο"].</translation>
    </message>
    <message>
        <source>Extent (needs the CRS of the grid)</source>
        <translation>Έκταση (χρειάζεται το ΣΑΣ του καννάβου)</translation>
    </message>
    <message>
        <source>Extent in the CRS of the grid [default: what all layers cover].</source>
        <translation>Έκταση στο ΣΑΣ του καννάβου [αλλιώς ό,τι καλύπτουν όλα τα επίπεδα].</translation>
    </message>
    <message>
        <source>Take the grid of this raster</source>
        <translation>Χρήση του καννάβου αυτού του ψηφιδωτού</translation>
    </message>
    <message>
        <source>Take the grid of this raster.</source>
        <translation>Χρησιμοποιεί τον κάνναβο αυτού του ψηφιδωτού.</translation>
    </message>
    <message>
        <source>True CRS of the layers, such as dem=EPSG:32635</source>
        <translation>Πραγματικό ΣΑΣ των επιπέδων, π.χ. dem=EPSG:32635</translation>
    </message>
    <message>
        <source>The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.</source>
        <translation>Το πραγματικό ΣΑΣ του dem, vegetation ή density, ή όλων, όπου ένα αρχείο δεν λέει κανένα ή λέει λάθος.</translation>
    </message>
    <message>
        <source>No-data values, such as dem=-9999; vegetation=255</source>
        <translation>Τιμές χωρίς δεδομένα, π.χ. dem=-9999; vegetation=255</translation>
    </message>
    <message>
        <source>Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says that all are data; several are separated by ;.</source>
        <translation>Τιμές που σημαίνουν χωρίς δεδομένα σε dem, vegetation ή density, π.χ. dem=-9999,32767· dem=none λέει ότι όλες είναι δεδομένα· πολλές χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Bands, such as dem=1; vegetation=2</source>
        <translation>Κανάλια, π.χ. dem=1; vegetation=2</translation>
    </message>
    <message>
        <source>Band to read of dem, vegetation or density.</source>
        <translation>Κανάλι που διαβάζεται από dem, vegetation ή density.</translation>
    </message>
    <message>
        <source>Codes that the legend does not list</source>
        <translation>Κωδικοί που λείπουν από το υπόμνημα</translation>
    </message>
    <message>
        <source>What to do with codes that the legend does not list.</source>
        <translation>Τι γίνεται με κωδικούς που λείπουν από το υπόμνημα.</translation>
    </message>
    <message>
        <source>Refuse them</source>
        <translation>Απόρριψη</translation>
    </message>
    <message>
        <source>Take them as land without fuel</source>
        <translation>Λογίζονται ως γη χωρίς καύσιμη ύλη</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of</source>
        <translation>Απόρριψη όσων αλλιώς θα έδιναν μόνο προειδοποίηση</translation>
    </message>
    <message>
        <source>Refuse what would only be warned of.</source>
        <translation>Απορρίπτει όσα αλλιώς θα έδιναν μόνο προειδοποίηση.</translation>
    </message>
    <message>
        <source>Allow network addresses and archives</source>
        <translation>Επιτρέπονται διευθύνσεις δικτύου και συμπιεσμένα αρχεία</translation>
    </message>
    <message>
        <source>Allow "Elevation", "Vegetation" and "Vegetation density" to be network addresses or in archives.</source>
        <translation>Επιτρέπει τα "Υψόμετρο", "Βλάστηση" και "Πυκνότητα βλάστησης" να είναι διευθύνσεις δικτύου ή σε συμπιεσμένα αρχεία.</translation>
    </message>
    <message>
        <source>Most memory to use, such as 4GB</source>
        <translation>Μέγιστη μνήμη, π.χ. 4GB</translation>
    </message>
    <message>
        <source>Refuse work that needs more, e.g. 4GB [default: most of what there is].</source>
        <translation>Απορρίπτει εργασία που χρειάζεται περισσότερη, π.χ. 4GB [αλλιώς το μεγαλύτερο μέρος όσης υπάρχει].</translation>
    </message>
    <message>
        <source>Calibration, or the account (run.json) of an earlier run</source>
        <translation>Βαθμονόμηση, ή πρακτικό (run.json) προηγούμενης εκτέλεσης</translation>
    </message>
    <message>
        <source>Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.</source>
        <translation>Παίρνει παραμέτρους από αρχείο TOML, ή από το run.json προηγούμενης εκτέλεσης· όσα δίνονται εδώ υπερισχύουν.</translation>
    </message>
    <message>
        <source>Elevation on the common grid</source>
        <translation>Υψόμετρο στον κοινό κάνναβο</translation>
    </message>
    <message>
        <source>Vegetation classes on the common grid</source>
        <translation>Κλάσεις βλάστησης στον κοινό κάνναβο</translation>
    </message>
    <message>
        <source>Density classes on the common grid</source>
        <translation>Κλάσεις πυκνότητας στον κοινό κάνναβο</translation>
    </message>
    <message>
        <source>Effect of the vegetation, where the legend gives numbers in place of classes</source>
        <translation>Επίδραση της βλάστησης, όπου το υπόμνημα δίνει αριθμούς αντί για κλάσεις</translation>
    </message>
    <message>
        <source>Effect of the density, where the legend gives numbers in place of classes</source>
        <translation>Επίδραση της πυκνότητας, όπου το υπόμνημα δίνει αριθμούς αντί για κλάσεις</translation>
    </message>
    <message>
        <source>Rate of spread on flat calm dry ground, where the legend gives it</source>
        <translation>Ταχύτητα εξάπλωσης σε επίπεδο ξηρό έδαφος με άπνοια, όπου τη δίνει το υπόμνημα</translation>
    </message>
    <message>
        <source>Load of dead fuel, where the legend gives it</source>
        <translation>Φορτίο νεκρής καύσιμης ύλης, όπου το δίνει το υπόμνημα</translation>
    </message>
    <message>
        <source>Load of live fuel, where the legend gives it</source>
        <translation>Φορτίο ζωντανής καύσιμης ύλης, όπου το δίνει το υπόμνημα</translation>
    </message>
    <message>
        <source>Heat content of the fuel, where the legend gives it</source>
        <translation>Θερμογόνος δύναμη της καύσιμης ύλης, όπου τη δίνει το υπόμνημα</translation>
    </message>
    <message>
        <source>Moisture of the live fuel, where the legend gives it</source>
        <translation>Υγρασία της ζωντανής καύσιμης ύλης, όπου τη δίνει το υπόμνημα</translation>
    </message>
    <message>
        <source>Account of the run</source>
        <translation>Πρακτικό της εκτέλεσης</translation>
    </message>
    <message>
        <source>Folder for all files</source>
        <translation>Φάκελος για όλα τα αρχεία</translation>
    </message>
    <message>
        <source>Spread network</source>
        <translation>Δίκτυο εξάπλωσης</translation>
    </message>
    <message>
        <source>Find how likely fire spreads from each cell to its neighbours.</source>
        <translation>Βρίσκει πόσο πιθανό είναι να περάσει η φωτιά από κάθε κελί στα γειτονικά του.</translation>
    </message>
    <message>
        <source>Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). Wind and slope then act on the times; so make a network without times for fires without a duration.</source>
        <translation>Τα κανάλια 1 έως 8 περιέχουν την πιθανότητα να περάσει η φωτιά προς Β, ΒΑ, Α, ΝΑ, Ν, ΝΔ, Δ και ΒΔ. Αν δίνονται και χρόνοι, τα κανάλια 9 έως 16 περιέχουν τα δευτερόλεπτα που χρειάζονται, και το κανάλι 17 τη θερμότητα που εκλύει το κελί (kJ/m2). Ο άνεμος και η κλίση επιδρούν τότε στους χρόνους· για πυρκαγιές χωρίς διάρκεια φτιάξτε λοιπόν δίκτυο χωρίς χρόνους.</translation>
    </message>
    <message>
        <source>Cells with fuel</source>
        <translation>Κελιά με καύσιμη ύλη</translation>
    </message>
    <message>
        <source>Spread model</source>
        <translation>Μοντέλο εξάπλωσης</translation>
    </message>
    <message>
        <source>How fire gets from a cell to its neighbours; all are described below.</source>
        <translation>Πώς φτάνει η φωτιά από ένα κελί στα γειτονικά του· όλα περιγράφονται παρακάτω.</translation>
    </message>
    <message>
        <source>Alexandridis: cellular automaton of vegetation type, density, slope and wind</source>
        <translation>Alexandridis: κυτταρικό αυτόματο τύπου βλάστησης, πυκνότητας, κλίσης και ανέμου</translation>
    </message>
    <message>
        <source>Artificial forest: the probability of catching fire is the fuel of the target cell</source>
        <translation>Τεχνητό δάσος: η πιθανότητα ανάφλεξης είναι η καύσιμη ύλη του κελιού προορισμού</translation>
    </message>
    <message>
        <source>Raster: your own probabilities, and perhaps travel times, from another fire model</source>
        <translation>Ψηφιδωτό: δικές σας πιθανότητες, και αν υπάρχουν χρόνοι, από άλλο μοντέλο πυρκαγιάς</translation>
    </message>
    <message>
        <source>Wind speed [m/s]</source>
        <translation>Ταχύτητα ανέμου [m/s]</translation>
    </message>
    <message>
        <source>Wind speed at mid-flame height in m/s, or a raster of it on any grid.</source>
        <translation>Ταχύτητα ανέμου στο μισό ύψος της φλόγας σε m/s, ή ψηφιδωτό της σε οποιονδήποτε κάνναβο.</translation>
    </message>
    <message>
        <source>Wind from [degrees clockwise from north]</source>
        <translation>Άνεμος από [μοίρες δεξιόστροφα από τον βορρά]</translation>
    </message>
    <message>
        <source>Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.</source>
        <translation>Διεύθυνση από όπου έρχεται ο άνεμος, δεξιόστροφα από τον βορρά: 270 είναι δυτικός άνεμος· αριθμός ή ψηφιδωτό.</translation>
    </message>
    <message>
        <source>Tell times too (for fires with a duration)</source>
        <translation>Να δίνονται και χρόνοι (για πυρκαγιές με διάρκεια)</translation>
    </message>
    <message>
        <source>Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.</source>
        <translation>Δίνει και πόση ώρα χρειάζεται η φωτιά από κελί σε κελί (κανάλια 9 έως 16, δευτερόλεπτα) και τη θερμότητα κάθε κελιού.</translation>
    </message>
    <message>
        <source>as a raster</source>
        <translation>ως ψηφιδωτό</translation>
    </message>
    <message>
        <source>Wind towards east and north, in place of speed and direction [m/s]</source>
        <translation>Άνεμος προς ανατολή και βορρά, αντί για ταχύτητα και διεύθυνση [m/s]</translation>
    </message>
    <message>
        <source>Components of the wind towards east and north, in place of the two above: rasters on any grid.</source>
        <translation>Συνιστώσες του ανέμου προς ανατολή και βορρά, αντί για τα δύο παραπάνω: ψηφιδωτά σε οποιονδήποτε κάνναβο.</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel (8 % is 0.08)</source>
        <translation>Υγρασία της λεπτής νεκρής καύσιμης ύλης (8 % είναι 0.08)</translation>
    </message>
    <message>
        <source>Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.</source>
        <translation>Υγρασία της λεπτής νεκρής καύσιμης ύλης ως μέρος του ξηρού βάρους της (8 % είναι 0.08 ή 8%), ή ψηφιδωτό της.</translation>
    </message>
    <message>
        <source>Neighbours that a cell can light</source>
        <translation>Γειτονικά κελιά που μπορεί να ανάψει ένα κελί</translation>
    </message>
    <message>
        <source>Cells to which fire can spread from a cell.</source>
        <translation>Κελιά στα οποία μπορεί να περάσει η φωτιά από ένα κελί.</translation>
    </message>
    <message>
        <source>All eight</source>
        <translation>Και τα οκτώ</translation>
    </message>
    <message>
        <source>The four that share a side</source>
        <translation>Τα τέσσερα με κοινή πλευρά</translation>
    </message>
    <message>
        <source>Parameters of the spread model, such as p0=0.5</source>
        <translation>Παράμετροι του μοντέλου εξάπλωσης, π.χ. p0=0.5</translation>
    </message>
    <message>
        <source>Parameter of the spread model, e.g. p0=0.5; several are separated by ;.</source>
        <translation>Παράμετρος του μοντέλου εξάπλωσης, π.χ. p0=0.5· πολλές χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>File with the probabilities for other tools (.mtx, .npz)</source>
        <translation>Αρχείο με τις πιθανότητες για άλλα προγράμματα (.mtx, .npz)</translation>
    </message>
    <message>
        <source>Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or .graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.</source>
        <translation>Γράφει και τις πιθανότητες για άλλα προγράμματα: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) ή .graphml (έως 20,000 κελιά με καύσιμη ύλη). Τα κελιά αριθμούνται γραμμή προς γραμμή από πάνω αριστερά.</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Δυαδικά ψηφία ανά αριθμό</translation>
    </message>
    <message>
        <source>Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; with 8 by 0.002 and 3.4 %. Every command reads such files.</source>
        <translation>Bit ανά αριθμό στο αρχείο. Με 16 οι πιθανότητες απέχουν το πολύ 8e-6, οι χρόνοι και η θερμότητα 0.013 %· με 8 απέχουν 0.002 και 3.4 %. Κάθε εντολή διαβάζει τέτοια αρχεία.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Ακριβώς</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 δυαδικά ψηφία</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 δυαδικά ψηφία</translation>
    </message>
    <message>
        <source>Where a line can be held</source>
        <translation>Πού μπορεί να κρατηθεί μια γραμμή</translation>
    </message>
    <message>
        <source>Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by it.</source>
        <translation>Βαθμολογεί από 0 έως 1 πόσο καλά κρατιέται μια γραμμή σε κάθε κελί: όσο αξίζει η καλύτερη γραμμή κοντά (κορυφογραμμές, κοιλάδες, δρόμοι, ποτάμια, όρια της καύσιμης ύλης), με την κλίση για τα μηχανήματα και την πρόσβαση. Τα σχέδια το ακολουθούν.</translation>
    </message>
    <message>
        <source>The weights have no source for your region: they are yours to set.</source>
        <translation>Οι συντελεστές δεν έχουν πηγή για την περιοχή σας: τους ορίζετε εσείς.</translation>
    </message>
    <message>
        <source>Mean suitability where there is fuel</source>
        <translation>Μέση καταλληλότητα όπου υπάρχει καύσιμη ύλη</translation>
    </message>
    <message>
        <source>Roads and tracks</source>
        <translation>Δρόμοι και δασόδρομοι</translation>
    </message>
    <message>
        <source>Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which crews drive; those that stop fire are barriers too.</source>
        <translation>Δρόμοι και μονοπάτια (γραμμές ή ράστερ), δίπλα στους οποίους οι ζώνες φτιάχνονται και κρατιούνται ευκολότερα, και στους οποίους κινούνται τα συνεργεία· όσοι σταματούν τη φωτιά είναι και εμπόδια.</translation>
    </message>
    <message>
        <source>Rivers and lakes</source>
        <translation>Ποτάμια και λίμνες</translation>
    </message>
    <message>
        <source>Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are barriers too.</source>
        <translation>Ποτάμια και λίμνες (γραμμές, επιφάνειες, ράστερ), δίπλα στα οποία οι ζώνες κρατιούνται ευκολότερα· όσα σταματούν τη φωτιά είναι και εμπόδια.</translation>
    </message>
    <message>
        <source>What lines of the ground are worth, such as ridge=0.8; reach=60</source>
        <translation>Τι αξίζουν οι γραμμές του εδάφους, π.χ. ridge=0.8; reach=60</translation>
    </message>
    <message>
        <source>What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; several are separated by ;.</source>
        <translation>Τι αξίζει μια γραμμή, ή μια απόσταση, π.χ. ridge=0.8, valley=0 ή reach=60· πολλά χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines</source>
        <translation>Διαμερίσματα που ορίζονται από γραμμές ελέγχου</translation>
    </message>
    <message>
        <source>Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: potential operational delineations (PODs), on which crews agree before a fire.</source>
        <translation>Διαίρεση του τοπίου σε διαμερίσματα παρόμοιου μεγέθους, που τα ορίζουν οι γραμμές που κρατιούνται πιο εύκολα: δυνητικές επιχειρησιακές οριοθετήσεις (PODs), τις οποίες συμφωνούν τα συνεργεία πριν από μια φωτιά.</translation>
    </message>
    <message>
        <source>Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. The second layer of the file holds the borders.</source>
        <translation>Κάθε διαμέρισμα έχει την καύσιμη ύλη του, τις ενάρξεις και τις αξίες του, όσα καίγονται σε προσομοιωμένες φωτιές και το πόσο καλό είναι το όριό του. Το δεύτερο επίπεδο του αρχείου περιέχει τα όρια.</translation>
    </message>
    <message>
        <source>Compartments</source>
        <translation>Διαμερίσματα</translation>
    </message>
    <message>
        <source>Borders in kilometres</source>
        <translation>Όρια σε χιλιόμετρα</translation>
    </message>
    <message>
        <source>Mean suitability of the borders</source>
        <translation>Μέση καταλληλότητα των ορίων</translation>
    </message>
    <message>
        <source>Size of the compartments, such as 500ha</source>
        <translation>Μέγεθος των διαμερισμάτων, π.χ. 500ha</translation>
    </message>
    <message>
        <source>Size of the compartments, hectares of fuel; none is larger than one and a half times this.</source>
        <translation>Μέγεθος των διαμερισμάτων, σε εκτάρια καύσιμης ύλης· κανένα δεν ξεπερνά τη μιάμιση φορά αυτή την τιμή.</translation>
    </message>
    <message>
        <source>Values at risk</source>
        <translation>Αξίες σε κίνδυνο</translation>
    </message>
    <message>
        <source>Values at risk: a raster, or polygons or points with "Field with the value" [default: 1 on fuel].</source>
        <translation>Αξίες σε κίνδυνο: ψηφιδωτό, ή πολύγωνα ή σημεία με "Πεδίο με την αξία" [αλλιώς 1 στην καύσιμη ύλη].</translation>
    </message>
    <message>
        <source>How long fires burn, such as 8h</source>
        <translation>Πόσο διαρκούν οι πυρκαγιές, π.χ. 8h</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: lognormal:8h,0.7, an assumption].</source>
        <translation>Πόσο διαρκούν οι πυρκαγιές: 8h, λίστα που παίρνουν με τη σειρά οι εκτελέσεις (4h,8h), lognormal:8h,0.7 (διάμεσος και σίγμα), uniform:2h,12h, ή weather [αλλιώς lognormal:8h,0.7, μια παραδοχή].</translation>
    </message>
    <message>
        <source>Ignition points</source>
        <translation>Σημεία έναρξης</translation>
    </message>
    <message>
        <source>Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of ignition probability [default: one random cell with fuel a run].</source>
        <translation>Σημεία, πολύγωνα (περίμετροι που ήδη καίγονται· κάθε διανυσματικό αρχείο, ή CSV με x και y) ή ψηφιδωτό πιθανότητας έναρξης [αλλιώς ένα τυχαίο κελί με καύσιμη ύλη ανά εκτέλεση].</translation>
    </message>
    <message>
        <source>Number of fires</source>
        <translation>Αριθμός πυρκαγιών</translation>
    </message>
    <message>
        <source>Simulated fires.</source>
        <translation>Προσομοιωμένες πυρκαγιές.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Σπόρος τυχαίων αριθμών</translation>
    </message>
    <message>
        <source>Seed of all draws.</source>
        <translation>Σπόρος όλων των κληρώσεων.</translation>
    </message>
    <message>
        <source>How much more the worst ground counts than the best</source>
        <translation>Πόσο περισσότερο μετρά το χειρότερο έδαφος από το καλύτερο</translation>
    </message>
    <message>
        <source>Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.</source>
        <translation>Πόσες φορές μετρά το χειρότερο έδαφος όσο το καλύτερο, 1 έως 100· με 1 ζητούνται τα συντομότερα όρια.</translation>
    </message>
    <message>
        <source>Field with the value</source>
        <translation>Πεδίο με την αξία</translation>
    </message>
    <message>
        <source>Column of the value polygons or points [default: 1 for each].</source>
        <translation>Στήλη των πολυγώνων ή σημείων αξίας [αλλιώς 1 για το καθένα].</translation>
    </message>
    <message>
        <source>Values are</source>
        <translation>Οι αξίες είναι</translation>
    </message>
    <message>
        <source>What the numbers of "Values at risk" are: so much in each cell of the raster, polygon or point (people), the sum of which is kept; or so much a hectare.</source>
        <translation>Τι είναι οι αριθμοί των "Αξίες σε κίνδυνο": τόσο σε κάθε κελί του ψηφιδωτού, πολύγωνο ή σημείο (άνθρωποι), με το άθροισμα να διατηρείται· ή τόσο ανά εκτάριο.</translation>
    </message>
    <message>
        <source>So much in each cell, polygon or point</source>
        <translation>Τόσο σε κάθε κελί, πολύγωνο ή σημείο</translation>
    </message>
    <message>
        <source>So much a hectare</source>
        <translation>Τόσο ανά εκτάριο</translation>
    </message>
    <message>
        <source>Several values at risk, such as people=villages.gpkg,weight=2</source>
        <translation>Πολλές αξίες σε κίνδυνο, π.χ. people=villages.gpkg,weight=2</translation>
    </message>
    <message>
        <source>Several values at risk, each as a name and a file, with its field, a weight (what a unit counts in the sum that is planned for) and as=density after it as needed; several are separated by ;, each is told by name.</source>
        <translation>Πολλές αξίες σε κίνδυνο, καθεμία ως όνομα και αρχείο, και μετά, αν χρειάζεται, το πεδίο της, ένα βάρος (πόσο μετρά μια μονάδα στο άθροισμα για το οποίο γίνεται το σχέδιο) και as=density· πολλές χωρίζονται με ;, καθεμία δίνεται με το όνομά της.</translation>
    </message>
    <message>
        <source>Conditions on features, such as barriers=highway = 'primary'</source>
        <translation>Συνθήκες για στοιχεία, π.χ. barriers=highway = 'primary'</translation>
    </message>
    <message>
        <source>Take only features that fit a condition, with the name of the layer before it, such as barriers=highway = 'primary'; several are separated by ;.</source>
        <translation>Παίρνει μόνο στοιχεία που πληρούν μια συνθήκη, με το όνομα του επιπέδου μπροστά, π.χ. barriers=highway = 'primary'· πολλές χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Use of the ignition points</source>
        <translation>Χρήση των σημείων έναρξης</translation>
    </message>
    <message>
        <source>With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or start where such fires of the past are dense.</source>
        <translation>Με σημεία ή πολύγωνα: οι εκτελέσεις τα παίρνουν με τη σειρά (ο σπόρος κληρώνει τη σειρά), αρχίζουν από όλα, ή αρχίζουν όπου τέτοιες πυρκαγιές του παρελθόντος είναι πυκνές.</translation>
    </message>
    <message>
        <source>One for each fire, in turn</source>
        <translation>Ένα για κάθε πυρκαγιά, με τη σειρά</translation>
    </message>
    <message>
        <source>All at once in every fire</source>
        <translation>Όλα μαζί σε κάθε πυρκαγιά</translation>
    </message>
    <message>
        <source>More fires where they are dense</source>
        <translation>Περισσότερες πυρκαγιές όπου είναι πυκνά</translation>
    </message>
    <message>
        <source>Ignition points without fuel</source>
        <translation>Σημεία έναρξης χωρίς καύσιμη ύλη</translation>
    </message>
    <message>
        <source>What to do with points and polygons off the landscape or without fuel.</source>
        <translation>Τι γίνεται με σημεία και πολύγωνα έξω από το τοπίο ή χωρίς καύσιμη ύλη.</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Παραλείπονται</translation>
    </message>
    <message>
        <source>Column with the hour of each ignition</source>
        <translation>Στήλη με την ώρα κάθε έναρξης</translation>
    </message>
    <message>
        <source>Column of the ignitions that tells when each is lit, in hours after the start of the run.</source>
        <translation>Στήλη των σημείων έναρξης που λέει πότε ανάβει το καθένα, σε ώρες μετά την αρχή της εκτέλεσης.</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Καύτρες</translation>
    </message>
    <message>
        <source>Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.</source>
        <translation>Καύτρες που πετούν μπροστά από τη φωτιά: on, ή αριθμοί όπως rate=12,longest=1000 αντί για τους υποτιθέμενους.</translation>
    </message>
    <message>
        <source>When crews contain a fire, such as 6h</source>
        <translation>Πότε τα συνεργεία περιορίζουν μια πυρκαγιά, π.χ. 6h</translation>
    </message>
    <message>
        <source>When crews contain each fire: a time or a distribution as for "How long fires burn", or a direct attack at such a time, which fails if the fire is too large or too fierce by then: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].</source>
        <translation>Πότε τα συνεργεία περιορίζουν κάθε πυρκαγιά: χρόνος ή κατανομή όπως στο "Πόσο διαρκούν οι πυρκαγιές", ή άμεση προσβολή σε τέτοιο χρόνο, που αποτυγχάνει αν η φωτιά είναι τότε πολύ μεγάλη ή σφοδρή: attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha πάνω από αυτό) [αλλιώς ποτέ].</translation>
    </message>
    <message>
        <source>How often a break holds, such as 0.47</source>
        <translation>Πόσο συχνά κρατά μια ζώνη, π.χ. 0.47</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: 0.47, an assumption].</source>
        <translation>Πόσο συχνά κρατά ένα κομμάτι ζώνης σε μια εκτέλεση: ποσοστό (0.47 στο πεδίο), flame (κατά το πλάτος και την ένταση της φωτιάς, Wilson 1988) ή flame:flames (1.5 μήκη φλόγας)· τα κομμάτια έχουν 400 m, ή όπως στο 0.47:800 [αλλιώς 0.47, μια παραδοχή].</translation>
    </message>
    <message>
        <source>How often a barrier holds, such as 0.9</source>
        <translation>Πόσο συχνά κρατά ένα εμπόδιο, π.χ. 0.9</translation>
    </message>
    <message>
        <source>Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.</source>
        <translation>Ποσοστό των εκτελέσεων όπου κρατά ένα κομμάτι των εμποδίων· κληρώνεται χωριστά από τις ζώνες.</translation>
    </message>
    <message>
        <source>Stations of crews whom breaks wait for</source>
        <translation>Σταθμοί των συνεργείων που περιμένουν οι ζώνες</translation>
    </message>
    <message>
        <source>Points or areas that crews set out from: a stretch of break holds only against fire that comes after them [default: crews are everywhere].</source>
        <translation>Σημεία ή περιοχές από όπου ξεκινούν τα συνεργεία: ένα κομμάτι ζώνης κρατά μόνο απέναντι σε φωτιά που έρχεται μετά από αυτά [αλλιώς τα συνεργεία είναι παντού].</translation>
    </message>
    <message>
        <source>Travel of crews, such as road=40,off=3,delay=10</source>
        <translation>Μετακίνηση των συνεργείων, π.χ. road=40,off=3,delay=10</translation>
    </message>
    <message>
        <source>How they travel: speed on roads and off them in km/h, and minutes from the start of the fire until they leave [default: road=40,off=3,delay=10, assumptions].</source>
        <translation>Πώς μετακινούνται: ταχύτητα σε δρόμους και εκτός δρόμων σε km/h, και λεπτά από την αρχή της φωτιάς ώσπου να ξεκινήσουν [αλλιώς road=40,off=3,delay=10, παραδοχές].</translation>
    </message>
    <message>
        <source>Fires without an end by time</source>
        <translation>Πυρκαγιές χωρίς χρονικό τέλος</translation>
    </message>
    <message>
        <source>Fires end by themselves and breaks hold in every fire unless "How often a break holds" says otherwise, as in the paper.</source>
        <translation>Οι πυρκαγιές τελειώνουν μόνες τους και οι ζώνες κρατούν σε κάθε πυρκαγιά, αν το "Πόσο συχνά κρατά μια ζώνη" δεν λέει άλλο, όπως στη δημοσίευση.</translation>
    </message>
    <message>
        <source>Table of weather</source>
        <translation>Πίνακας καιρού</translation>
    </message>
    <message>
        <source>Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2.</source>
        <translation>Σύνολο καιρικών συνθηκών, από τις οποίες κάθε εκτέλεση κληρώνει μία: αρχείο CSV με wind_speed_kmh, wind_from, moisture_pct, weight, duration_h, time· ή ροδόγραμμα ανέμου όπως rose:NW=5x0.4,N=8x0.2.</translation>
    </message>
    <message>
        <source>as a wind rose: rose:NW=5x0.4,N=8x0.2</source>
        <translation>ως ροδόγραμμα ανέμου: rose:NW=5x0.4,N=8x0.2</translation>
    </message>
    <message>
        <source>Time of each line of the table of weather, such as 1h</source>
        <translation>Διάρκεια κάθε γραμμής του πίνακα καιρού, π.χ. 1h</translation>
    </message>
    <message>
        <source>The lines of the weather follow each other, and each lasts so long, e.g. 1h.</source>
        <translation>Οι γραμμές του καιρού ακολουθούν η μία την άλλη, και καθεμία διαρκεί τόσο, π.χ. 1h.</translation>
    </message>
    <message>
        <source>Columns of the table of weather, such as wind_speed=FF</source>
        <translation>Στήλες του πίνακα καιρού, π.χ. wind_speed=FF</translation>
    </message>
    <message>
        <source>Name of a column of the weather, e.g. wind_speed=FF; several are separated by ;.</source>
        <translation>Όνομα μιας στήλης του καιρού, π.χ. wind_speed=FF· πολλά χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Units of the table of weather, such as wind_speed=kn</source>
        <translation>Μονάδες του πίνακα καιρού, π.χ. wind_speed=kn</translation>
    </message>
    <message>
        <source>Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; several are separated by ;.</source>
        <translation>Μονάδα μιας στήλης του καιρού που δεν τη λέει, π.χ. wind_speed=kn· πολλές χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Columns of the table of weather to leave out</source>
        <translation>Στήλες του πίνακα καιρού που παραλείπονται</translation>
    </message>
    <message>
        <source>Columns of the weather to leave out, separated by commas.</source>
        <translation>Στήλες του καιρού που παραλείπονται, χωρισμένες με κόμματα.</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, and their borders</source>
        <translation>Διαμερίσματα που ορίζονται από γραμμές ελέγχου, και τα όριά τους</translation>
    </message>
    <message>
        <source>Compartments bounded by control lines, without outlines</source>
        <translation>Διαμερίσματα που ορίζονται από γραμμές ελέγχου, χωρίς περιγράμματα</translation>
    </message>
    <message>
        <source>Borders of the compartments, without lines</source>
        <translation>Όρια των διαμερισμάτων, χωρίς γραμμές</translation>
    </message>
    <message>
        <source>Plan fire breaks</source>
        <translation>Σχεδιασμός αντιπυρικών ζωνών</translation>
    </message>
    <message>
        <source>Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and with the breaks.</source>
        <translation>Σχεδιάζει αντιπυρικές ζώνες από επίπεδα: πού να κοπεί, τι να κατασκευαστεί πρώτο, και πόσο συχνά καίγεται κάθε κελί χωρίς και με τις ζώνες.</translation>
    </message>
    <message>
        <source>Cells cut</source>
        <translation>Κελιά που κόβονται</translation>
    </message>
    <message>
        <source>Area cut in hectares</source>
        <translation>Έκταση που κόβεται σε εκτάρια</translation>
    </message>
    <message>
        <source>Mean burnt share without breaks</source>
        <translation>Μέσο καμένο ποσοστό χωρίς ζώνες</translation>
    </message>
    <message>
        <source>Mean burnt share with the breaks</source>
        <translation>Μέσο καμένο ποσοστό με τις ζώνες</translation>
    </message>
    <message>
        <source>Area where nothing may be cut</source>
        <translation>Περιοχή όπου δεν επιτρέπεται κοπή</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.</source>
        <translation>Περιοχή (ψηφιδωτό ή πολύγωνα· οι γραμμές παίρνουν τα κελιά που αγγίζουν) όπου δεν επιτρέπεται κοπή.</translation>
    </message>
    <message>
        <source>Existing barriers</source>
        <translation>Υπάρχοντα εμπόδια</translation>
    </message>
    <message>
        <source>Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and cost nothing.</source>
        <translation>Υπάρχουσες ζώνες, δρόμοι, ποτάμια (ψηφιδωτό, γραμμές ή πολύγωνα): όλα τα κελιά που κόβουν δεν έχουν καύσιμη ύλη και δεν κοστίζουν.</translation>
    </message>
    <message>
        <source>Budget, such as 10%, 5ha or 20000eur</source>
        <translation>Προϋπολογισμός, π.χ. 10%, 5ha ή 20000eur</translation>
    </message>
    <message>
        <source>How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or money such as 20000eur, in the currency of the costs.</source>
        <translation>Πόσο θα κοπεί: ποσοστό των κελιών με καύσιμη ύλη όπως 10% ή 0.1, έκταση όπως 5ha, ή χρήματα όπως 20000eur, στο νόμισμα του κόστους.</translation>
    </message>
    <message>
        <source>Ranking</source>
        <translation>Μέθοδος κατάταξης</translation>
    </message>
    <message>
        <source>By which cells are ranked; higher is cut earlier. All are described below.</source>
        <translation>Με τι κατατάσσονται τα κελιά· το ψηλότερο κόβεται νωρίτερα. Όλες περιγράφονται παρακάτω.</translation>
    </message>
    <message>
        <source>Betweenness centrality: cells that lie on many fastest routes of fire</source>
        <translation>Ενδιαμεσική κεντρικότητα: κελιά πάνω σε πολλές ταχύτερες διαδρομές της φωτιάς</translation>
    </message>
    <message>
        <source>Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves</source>
        <translation>Κεντρικότητα Bonacich: κελιά μέσω των οποίων η φωτιά φτάνει σε κελιά που και αυτά προσεγγίζονται εύκολα</translation>
    </message>
    <message>
        <source>Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere</source>
        <translation>Κεντρικότητα εγγύτητας: κελιά όπου η φωτιά φτάνει σύντομα από παντού, ή από όπου φτάνει σύντομα παντού</translation>
    </message>
    <message>
        <source>Compartments: a square grid of bands that encloses equal ones</source>
        <translation>Διαμερίσματα: τετραγωνικό πλέγμα λωρίδων που περικλείει ίσα διαμερίσματα</translation>
    </message>
    <message>
        <source>Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone</source>
        <translation>Ενδιαμεσικότητα ροής ρεύματος: κελιά από όπου περνά η εξάπλωση από οποιαδήποτε διαδρομή, όχι μόνο την ταχύτερη</translation>
    </message>
    <message>
        <source>Degree: cells that are lit by, or light, their neighbours most</source>
        <translation>Βαθμός: κελιά που ανάβουν περισσότερο από τα γειτονικά τους, ή τα ανάβουν</translation>
    </message>
    <message>
        <source>Defensible fuel profile zones (DFPZ): broad bands along roads and ridges</source>
        <translation>Υπερασπίσιμες ζώνες καύσιμης ύλης (DFPZ): φαρδιές λωρίδες κατά μήκος δρόμων και ραχών</translation>
    </message>
    <message>
        <source>Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first</source>
        <translation>Κατάτμηση: τοίχοι ανάμεσα σε διαμερίσματα με ένθετες ελάχιστες τομές, πρώτα όσοι σώζουν περισσότερα για το κόστος τους</translation>
    </message>
    <message>
        <source>Dominator: exact gain of cutting one cell, found anew after every few cuts</source>
        <translation>Κυρίαρχος: ακριβές κέρδος από την κοπή ενός κελιού, υπολογισμένο εκ νέου κάθε λίγες κοπές</translation>
    </message>
    <message>
        <source>DomiRank: cells that dominate their neighbourhood when neighbours compete</source>
        <translation>DomiRank: κελιά που κυριαρχούν στη γειτονιά τους όταν τα γειτονικά ανταγωνίζονται</translation>
    </message>
    <message>
        <source>Downstream protection value: cells from which most value was lit, found anew after every few cuts</source>
        <translation>Αξία προστασίας κατάντη: κελιά από τα οποία άναψε η περισσότερη αξία, υπολογισμένη εκ νέου κάθε λίγες κοπές</translation>
    </message>
    <message>
        <source>Eigenvector centrality: cells next to the cells that matter most, all in one place of the map</source>
        <translation>Κεντρικότητα ιδιοδιανύσματος: κελιά δίπλα στα σημαντικότερα κελιά, όλα σε ένα μέρος του χάρτη</translation>
    </message>
    <message>
        <source>Flammability: most flammable cells first, the conventional policy, which looks at each cell alone</source>
        <translation>Ευφλεκτότητα: πρώτα τα πιο εύφλεκτα κελιά, η συνήθης πρακτική, που κοιτά κάθε κελί χωριστά</translation>
    </message>
    <message>
        <source>Group betweenness: built cell by cell, each covers fastest routes that the group leaves open</source>
        <translation>Ομαδική ενδιαμεσικότητα: χτίζεται κελί προς κελί, καθένα καλύπτει ταχύτερες διαδρομές που η ομάδα αφήνει ανοιχτές</translation>
    </message>
    <message>
        <source>Influence: cells by way of which fires with a clock take most, found anew after every few cuts on the same draws</source>
        <translation>Επιρροή: κελιά μέσω των οποίων οι φωτιές με χρονόμετρο καίνε τα περισσότερα, που βρίσκονται εκ νέου ύστερα από κάθε λίγες κοπές με τις ίδιες κληρώσεις</translation>
    </message>
    <message>
        <source>Information centrality: cells that many parallel ways of spread join closely to all others</source>
        <translation>Κεντρικότητα πληροφορίας: κελιά που πολλοί παράλληλοι δρόμοι εξάπλωσης τα συνδέουν στενά με όλα τα άλλα</translation>
    </message>
    <message>
        <source>PageRank: cells that a fire wandering at random from cell to cell is often in</source>
        <translation>PageRank: κελιά όπου βρίσκεται συχνά μια φωτιά που περιπλανιέται τυχαία από κελί σε κελί</translation>
    </message>
    <message>
        <source>Percolation centrality: cells on many fastest routes from where fires start</source>
        <translation>Κεντρικότητα διήθησης: κελιά πάνω σε πολλές ταχύτερες διαδρομές από εκεί όπου αρχίζουν πυρκαγιές</translation>
    </message>
    <message>
        <source>Random: cells in random order, the baseline that every plan must beat</source>
        <translation>Τυχαία: κελιά σε τυχαία σειρά, το μέτρο που κάθε σχέδιο πρέπει να ξεπεράσει</translation>
    </message>
    <message>
        <source>Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them</source>
        <translation>Στρατηγικά τοποθετημένες περιοχές χειρισμού (SPLAT): εναλλασσόμενες κηλίδες που επιβραδύνουν τη φωτιά, χωρίς ευθύ πέρασμα</translation>
    </message>
    <message>
        <source>Stripes: parallel bands across a direction, the plainest pattern of practice</source>
        <translation>Λωρίδες: παράλληλες λωρίδες κάθετα σε μια διεύθυνση, το απλούστερο σχέδιο της πράξης</translation>
    </message>
    <message>
        <source>Unit of a budget that is a plain number</source>
        <translation>Μονάδα ενός προϋπολογισμού που είναι απλός αριθμός</translation>
    </message>
    <message>
        <source>What a plain number for "Budget" counts: a share of the fuel, hectares, or money [default: share].</source>
        <translation>Τι μετρά ένας απλός αριθμός στο "Προϋπολογισμός": ποσοστό της καύσιμης ύλης, εκτάρια, ή χρήματα [αλλιώς ποσοστό].</translation>
    </message>
    <message>
        <source>Share of the fuel (0 to 1)</source>
        <translation>Ποσοστό της καύσιμης ύλης (0 έως 1)</translation>
    </message>
    <message>
        <source>Hectares</source>
        <translation>Εκτάρια</translation>
    </message>
    <message>
        <source>Money</source>
        <translation>Χρήματα</translation>
    </message>
    <message>
        <source>Parameters of the ranking, such as beta=0.5; width=60</source>
        <translation>Παράμετροι της μεθόδου κατάταξης, π.χ. beta=0.5; width=60</translation>
    </message>
    <message>
        <source>Parameter of the ranking, e.g. beta=0.5; several are separated by ;.</source>
        <translation>Παράμετρος της μεθόδου κατάταξης, π.χ. beta=0.5· πολλές χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Share of the spread that a break lets through</source>
        <translation>Ποσοστό της εξάπλωσης που αφήνει να περάσει μια ζώνη</translation>
    </message>
    <message>
        <source>Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.</source>
        <translation>Ποσοστό της πιθανότητας εξάπλωσής του που κρατά ένα κελί μετά τον χειρισμό· 0 είναι τέλεια ζώνη, οι πραγματικές διαρρέουν.</translation>
    </message>
    <message>
        <source>Least width of the breaks [m]</source>
        <translation>Ελάχιστο πλάτος των ζωνών [m]</translation>
    </message>
    <message>
        <source>Least width of the breaks, rounded up to whole cells [default: one cell, or the best for "Share of the spread that a break lets through"].</source>
        <translation>Ελάχιστο πλάτος των ζωνών, στρογγυλεμένο σε ολόκληρα κελιά [αλλιώς ένα κελί, ή το καλύτερο για "Ποσοστό της εξάπλωσης που αφήνει να περάσει μια ζώνη"].</translation>
    </message>
    <message>
        <source>Improve the breaks on simulated fires (takes longer)</source>
        <translation>Βελτίωση των ζωνών με προσομοιωμένες πυρκαγιές (διαρκεί περισσότερο)</translation>
    </message>
    <message>
        <source>Improve the breaks by local search on simulated fires; takes longer.</source>
        <translation>Βελτιώνει τις ζώνες με τοπική αναζήτηση σε προσομοιωμένες πυρκαγιές· διαρκεί περισσότερο.</translation>
    </message>
    <message>
        <source>Fires that the plan is made for</source>
        <translation>Πυρκαγιές για τις οποίες γίνεται το σχέδιο</translation>
    </message>
    <message>
        <source>What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).</source>
        <translation>Τι πρέπει να είναι μικρό: η απώλεια της μέσης πυρκαγιάς, ή εκείνη του χειρότερου δεκάτου των πυρκαγιών (CVaR).</translation>
    </message>
    <message>
        <source>The mean fire</source>
        <translation>Η μέση πυρκαγιά</translation>
    </message>
    <message>
        <source>The worst tenth of the fires</source>
        <translation>Το χειρότερο δέκατο των πυρκαγιών</translation>
    </message>
    <message>
        <source>Width of breaks that are lines [m]</source>
        <translation>Πλάτος των ζωνών που είναι γραμμές [m]</translation>
    </message>
    <message>
        <source>Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length times their width. With "How often a break holds" flame, auto is the width with which fires take least. cells cuts whole cells, as in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.</source>
        <translation>Πλάτος των γραμμών από τις οποίες αποτελούνται οι ζώνες, π.χ. 12m, και μικρότερο από ένα κελί· ο προϋπολογισμός μετρά το μήκος τους επί το πλάτος τους. Με "Πόσο συχνά κρατά μια ζώνη" flame, auto είναι το πλάτος με το οποίο οι πυρκαγιές καίνε το λιγότερο. Το cells κόβει ολόκληρα κελιά, όπως στο άρθρο. Προεπιλογή: γραμμές πλάτους ενός κελιού, το πολύ 30 m, όπου οι πυρκαγιές έχουν ρολόι και οι ζώνες δεν διαρρέουν.</translation>
    </message>
    <message>
        <source>Treatments (CSV, or default)</source>
        <translation>Χειρισμοί (CSV, ή default)</translation>
    </message>
    <message>
        <source>Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires burn with what they leave [default: all segments alike, by "Share of the spread that a break lets through"].</source>
        <translation>Πίνακας χειρισμών (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), ή default: κάθε τμήμα παίρνει εκείνον που σώζει περισσότερα για το κόστος του, ένας προϋπολογισμός σε χρήματα είναι όσα κοστίζουν, και οι πυρκαγιές καίνε με όσα αφήνουν [αλλιώς όλα τα τμήματα όμοια, κατά "Ποσοστό της εξάπλωσης που αφήνει να περάσει μια ζώνη"].</translation>
    </message>
    <message>
        <source>as a word</source>
        <translation>ως λέξη</translation>
    </message>
    <message>
        <source>Breaks that stand already</source>
        <translation>Ζώνες που υπάρχουν ήδη</translation>
    </message>
    <message>
        <source>Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.</source>
        <translation>Ζώνες που υπάρχουν ήδη (γραμμές, πολύγωνα ή ψηφιδωτό του οποίου κάθε συνεχόμενο κομμάτι είναι μία): οι πυρκαγιές τις συναντούν με και χωρίς το σχέδιο, αστοχούν όπως οι νέες, και η καύσιμη ύλη τους ξαναφυτρώνει αν δεν συντηρούνται.</translation>
    </message>
    <message>
        <source>as polygons or lines</source>
        <translation>ως πολύγωνα ή γραμμές</translation>
    </message>
    <message>
        <source>Years of building and upkeep</source>
        <translation>Έτη κατασκευής και συντήρησης</translation>
    </message>
    <message>
        <source>Number of years over which the breaks are built and kept up; 1: all is built at once.</source>
        <translation>Αριθμός ετών στα οποία κατασκευάζονται και συντηρούνται οι ζώνες· 1: όλα κατασκευάζονται μαζί.</translation>
    </message>
    <message>
        <source>Budget of each year, such as 500ha</source>
        <translation>Προϋπολογισμός κάθε έτους, π.χ. 500ha</translation>
    </message>
    <message>
        <source>What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share [default: what all breaks cost, over the years].</source>
        <translation>Όσα επιτρέπει κάθε έτος για συντήρηση, που πληρώνεται πρώτη, και κατασκευή: 500ha, 20000eur ή ποσοστό [αλλιώς όσα κοστίζουν όλες οι ζώνες, διά τα έτη].</translation>
    </message>
    <message>
        <source>Fires that start in a year</source>
        <translation>Πυρκαγιές που αρχίζουν σε ένα έτος</translation>
    </message>
    <message>
        <source>Number of fires that start in a year.</source>
        <translation>Αριθμός πυρκαγιών που αρχίζουν σε ένα έτος.</translation>
    </message>
    <message>
        <source>Discount rate a year, such as 3%</source>
        <translation>Προεξοφλητικό επιτόκιο ανά έτος, π.χ. 3%</translation>
    </message>
    <message>
        <source>Rate a year, such as 3%, at which later costs and losses count less.</source>
        <translation>Ετήσιο επιτόκιο, π.χ. 3%, με το οποίο τα μεταγενέστερα κόστη και οι απώλειες μετρούν λιγότερο.</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back</source>
        <translation>Έτη ώσπου να ξαναφυτρώσει η καύσιμη ύλη μετά τον χειρισμό</translation>
    </message>
    <message>
        <source>Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "Treatments", or agricultural=3,shrubs=4,pines=4, an assumption].</source>
        <translation>Έτη ώσπου να ξαναφυτρώσει η καύσιμη ύλη μετά τον χειρισμό: 4, ή agricultural=3,shrubs=4,pines=8 [αλλιώς εκείνα των "Χειρισμοί", ή agricultural=3,shrubs=4,pines=4, μια παραδοχή].</translation>
    </message>
    <message>
        <source>Cost of treating anew, as a share of treating first</source>
        <translation>Κόστος νέου χειρισμού, ως ποσοστό του πρώτου</translation>
    </message>
    <message>
        <source>What treating anew costs, as a share of treating first.</source>
        <translation>Πόσο κοστίζει ένας νέος χειρισμός, ως ποσοστό του πρώτου.</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare</source>
        <translation>Κόστος κοπής ανά εκτάριο</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost", or classes such as agricultural=500,shrubs=900,pines=1500.</source>
        <translation>Κόστος κοπής ανά εκτάριο: ψηφιδωτό, πολύγωνα με "Πεδίο με το κόστος", ή κλάσεις όπως agricultural=500,shrubs=900,pines=1500.</translation>
    </message>
    <message>
        <source>as classes: agricultural=500,pines=1500</source>
        <translation>ως κλάσεις: agricultural=500,pines=1500</translation>
    </message>
    <message>
        <source>Field with the cost</source>
        <translation>Πεδίο με το κόστος</translation>
    </message>
    <message>
        <source>Column of the cost polygons.</source>
        <translation>Στήλη των πολυγώνων κόστους.</translation>
    </message>
    <message>
        <source>Cost per hectare where none is known</source>
        <translation>Κόστος ανά εκτάριο όπου δεν είναι γνωστό</translation>
    </message>
    <message>
        <source>Cost per hectare where "Cost of cutting per hectare" tells none; alone, everywhere [default: nothing is cut there].</source>
        <translation>Κόστος ανά εκτάριο όπου το "Κόστος κοπής ανά εκτάριο" δεν λέει· μόνο του, παντού [αλλιώς εκεί δεν κόβεται τίποτα].</translation>
    </message>
    <message>
        <source>Area outside of which nothing may be cut</source>
        <translation>Περιοχή έξω από την οποία δεν επιτρέπεται κοπή</translation>
    </message>
    <message>
        <source>Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.</source>
        <translation>Περιοχή (ψηφιδωτό ή πολύγωνα· οι γραμμές παίρνουν τα κελιά που αγγίζουν) έξω από την οποία δεν επιτρέπεται κοπή.</translation>
    </message>
    <message>
        <source>Cells that protected and allowed areas keep</source>
        <translation>Κελιά που διατηρούν οι προστατευμένες και οι επιτρεπόμενες περιοχές</translation>
    </message>
    <message>
        <source>Cells that "Area where nothing may be cut" and "Area outside of which nothing may be cut" keep from being cut: all with a part inside the one or outside the other, or those whose centre is.</source>
        <translation>Κελιά που οι "Περιοχή όπου δεν επιτρέπεται κοπή" και "Περιοχή έξω από την οποία δεν επιτρέπεται κοπή" προφυλάσσουν από την κοπή: όλα με ένα μέρος μέσα στη μία ή έξω από την άλλη, ή εκείνα με το κέντρο τους εκεί.</translation>
    </message>
    <message>
        <source>Cells with any part in the area</source>
        <translation>Κελιά με οποιοδήποτε μέρος στην περιοχή</translation>
    </message>
    <message>
        <source>Cells whose centre is in the area</source>
        <translation>Κελιά με το κέντρο στην περιοχή</translation>
    </message>
    <message>
        <source>Area of interest that is planned for</source>
        <translation>Περιοχή για την οποία γίνεται το σχέδιο</translation>
    </message>
    <message>
        <source>Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start and burn there too.</source>
        <translation>Περιοχή (ράστερ ή πολύγωνα) για την οποία γίνεται το σχέδιο: έξω δεν κόβεται τίποτα, αλλά φωτιές ξεκινούν και καίνε κι εκεί.</translation>
    </message>
    <message>
        <source>How much more a break counts in bad ground (0: all ground alike)</source>
        <translation>Πόσο περισσότερο μετρά μια ζώνη σε κακό έδαφος (0: όλο το έδαφος ίδιο)</translation>
    </message>
    <message>
        <source>How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].</source>
        <translation>Πόσο περισσότερο μετρά μια ζώνη στο χειρότερο έδαφος απ' ό,τι σε κορυφογραμμή, δρόμο, ποτάμι ή στο όριο της καύσιμης ύλης· 0: όλο το έδαφος ίδιο, όπως στο άρθρο [προεπιλογή: 1.5 όπου το έδαφος είναι γνωστό και έχει ανάγλυφο].</translation>
    </message>
    <message>
        <source>Steeper ground is not cut [degrees]</source>
        <translation>Πιο απότομο έδαφος δεν κόβεται [μοίρες]</translation>
    </message>
    <message>
        <source>Ground that is steeper is not cut.</source>
        <translation>Έδαφος που είναι πιο απότομο δεν κόβεται.</translation>
    </message>
    <message>
        <source>Cut only within this distance of roads, such as 200m</source>
        <translation>Κοπή μόνο σε τόση απόσταση από δρόμους, π.χ. 200m</translation>
    </message>
    <message>
        <source>Only ground within this of a road is cut: 200m.</source>
        <translation>Κόβεται μόνο έδαφος σε τόση απόσταση από δρόμο: 200m.</translation>
    </message>
    <message>
        <source>Cut nothing within this distance of roads, such as 50m</source>
        <translation>Καμία κοπή σε τόση απόσταση από δρόμους, π.χ. 50m</translation>
    </message>
    <message>
        <source>Ground within this of a road is not cut: 50m.</source>
        <translation>Έδαφος σε τόση απόσταση από δρόμο δεν κόβεται: 50m.</translation>
    </message>
    <message>
        <source>Fire breaks</source>
        <translation>Αντιπυρικές ζώνες</translation>
    </message>
    <message>
        <source>Fire breaks as polygons</source>
        <translation>Αντιπυρικές ζώνες ως πολύγωνα</translation>
    </message>
    <message>
        <source>Segments to build, in order</source>
        <translation>Τμήματα προς κατασκευή, με τη σειρά</translation>
    </message>
    <message>
        <source>Compartments between the breaks</source>
        <translation>Διαμερίσματα ανάμεσα στις ζώνες</translation>
    </message>
    <message>
        <source>The plan on one page: map, segments, doubt; opens in any browser</source>
        <translation>Το σχέδιο σε μία σελίδα: χάρτης, τμήματα, αβεβαιότητα· ανοίγει σε κάθε φυλλομετρητή</translation>
    </message>
    <message>
        <source>Cutting priority</source>
        <translation>Προτεραιότητα κοπής</translation>
    </message>
    <message>
        <source>What each cell would keep of its spread once treated</source>
        <translation>Τι θα κρατούσε κάθε κελί από την εξάπλωσή του μετά τον χειρισμό</translation>
    </message>
    <message>
        <source>Burn frequency without breaks</source>
        <translation>Συχνότητα καύσης χωρίς ζώνες</translation>
    </message>
    <message>
        <source>Burn frequency with the breaks</source>
        <translation>Συχνότητα καύσης με τις ζώνες</translation>
    </message>
    <message>
        <source>Existing breaks, what each is worth, and whether it is kept up</source>
        <translation>Υπάρχουσες ζώνες, τι αξίζει η καθεμία και αν συντηρείται</translation>
    </message>
    <message>
        <source>What the plan does for its goal and for all others</source>
        <translation>Τι πετυχαίνει το σχέδιο για τον στόχο του και για όλους τους άλλους</translation>
    </message>
    <message>
        <source>What is built, kept up and burnt in each year</source>
        <translation>Τι κατασκευάζεται, συντηρείται και καίγεται σε κάθε έτος</translation>
    </message>
    <message>
        <source>Size of every fire without and with the breaks</source>
        <translation>Μέγεθος κάθε πυρκαγιάς χωρίς και με τις ζώνες</translation>
    </message>
    <message>
        <source>Burnt share at every budget</source>
        <translation>Καμένο ποσοστό σε κάθε προϋπολογισμό</translation>
    </message>
    <message>
        <source>Cells burnt in every run of it</source>
        <translation>Καμένα κελιά σε κάθε εκτέλεσή του</translation>
    </message>
    <message>
        <source>Burnt share at every budget, without a clock and with perfect breaks</source>
        <translation>Καμένο ποσοστό σε κάθε προϋπολογισμό, χωρίς χρόνο και με τέλειες ζώνες</translation>
    </message>
    <message>
        <source>Picture of the plan</source>
        <translation>Εικόνα του σχεδίου</translation>
    </message>
    <message>
        <source>Rank cells</source>
        <translation>Κατάταξη κελιών</translation>
    </message>
    <message>
        <source>Rank the cells of a spread network by the order in which they should be cut: higher is earlier.</source>
        <translation>Κατατάσσει τα κελιά ενός δικτύου εξάπλωσης με τη σειρά που πρέπει να κοπούν: ψηλότερα σημαίνει νωρίτερα.</translation>
    </message>
    <message>
        <source>Rankings that lay a pattern for the budget give another order for another budget.</source>
        <translation>Οι μέθοδοι που χαράζουν σχέδιο για τον προϋπολογισμό δίνουν άλλη σειρά για άλλον προϋπολογισμό.</translation>
    </message>
    <message>
        <source>Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.</source>
        <translation>Οκτώ κανάλια με την πιθανότητα να περάσει η φωτιά προς Β, ΒΑ, Α, ΝΑ, Ν, ΝΔ, Δ και ΒΔ.</translation>
    </message>
    <message>
        <source>Elevation, for methods that follow ridges [m].</source>
        <translation>Υψόμετρο, για μεθόδους που ακολουθούν ράχες [m].</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: alike].</source>
        <translation>Πόσο πιθανό είναι να αρχίσει πυρκαγιά σε κάθε κελί, σε σχέση με τα άλλα [αλλιώς το ίδιο].</translation>
    </message>
    <message>
        <source>Cost of cutting per hectare: a raster, polygons with "Field with the cost".</source>
        <translation>Κόστος κοπής ανά εκτάριο: ψηφιδωτό, πολύγωνα με "Πεδίο με το κόστος".</translation>
    </message>
    <message>
        <source>Select fire breaks</source>
        <translation>Επιλογή αντιπυρικών ζωνών</translation>
    </message>
    <message>
        <source>Cut the cells of highest priority, as many as the budget allows.</source>
        <translation>Κόβει τα κελιά με την υψηλότερη προτεραιότητα, όσα επιτρέπει ο προϋπολογισμός.</translation>
    </message>
    <message>
        <source>Ties are cut by row, then column. A priority that was made for another budget is warned of.</source>
        <translation>Στις ισοβαθμίες η κοπή γίνεται κατά γραμμή, μετά κατά στήλη. Δίνεται προειδοποίηση για προτεραιότητα που έγινε για άλλον προϋπολογισμό.</translation>
    </message>
    <message>
        <source>Score by which cells are cut, higher is earlier.</source>
        <translation>Βαθμός με τον οποίο κόβονται τα κελιά, ψηλότερα σημαίνει νωρίτερα.</translation>
    </message>
    <message>
        <source>Cost per hectare, for budgets of money: a raster, or polygons with "Field with the cost".</source>
        <translation>Κόστος ανά εκτάριο, για προϋπολογισμούς σε χρήματα: ψηφιδωτό, ή πολύγωνα με "Πεδίο με το κόστος".</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority</source>
        <translation>Χρήση ψηφιδωτού που δεν γράφτηκε ως προτεραιότητα</translation>
    </message>
    <message>
        <source>Take a raster that was not written as a priority all the same: its greatest numbers are cut first.</source>
        <translation>Χρησιμοποιεί παρ' όλα αυτά ψηφιδωτό που δεν γράφτηκε ως προτεραιότητα: οι μεγαλύτεροι αριθμοί του κόβονται πρώτοι.</translation>
    </message>
    <message>
        <source>Segments to build</source>
        <translation>Τμήματα προς κατασκευή</translation>
    </message>
    <message>
        <source>Take fire breaks apart into segments to build, best first.</source>
        <translation>Χωρίζει τις αντιπυρικές ζώνες σε τμήματα προς κατασκευή, πρώτα τα καλύτερα.</translation>
    </message>
    <message>
        <source>Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope and cost, and the share of all that the breaks save that it adds.</source>
        <translation>Κάθε τμήμα χωρίζει δύο διαμερίσματα καύσιμης ύλης και έχει σειρά κατασκευής, μήκος, πλάτος, έκταση, μέση κλίση και κόστος, καθώς και το μερίδιο που προσθέτει σε όσα σώζουν οι ζώνες.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Τμήματα</translation>
    </message>
    <message>
        <source>Stages of construction</source>
        <translation>Στάδια κατασκευής</translation>
    </message>
    <message>
        <source>Length in kilometres</source>
        <translation>Μήκος σε χιλιόμετρα</translation>
    </message>
    <message>
        <source>Cells that are cut: 1, all others 0.</source>
        <translation>Κελιά που κόβονται: 1, όλα τα άλλα 0.</translation>
    </message>
    <message>
        <source>Ranking; decides between segments that save equally much.</source>
        <translation>Κατάταξη· αποφασίζει ανάμεσα σε τμήματα που σώζουν το ίδιο.</translation>
    </message>
    <message>
        <source>Elevation on any grid, for the slopes [m].</source>
        <translation>Υψόμετρο σε οποιονδήποτε κάνναβο, για τις κλίσεις [m].</translation>
    </message>
    <message>
        <source>What of the segments goes into a format with one layer</source>
        <translation>Τι από τα τμήματα μπαίνει σε μορφή με ένα επίπεδο</translation>
    </message>
    <message>
        <source>Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].</source>
        <translation>Επίπεδο των τμημάτων που γράφεται: μέσες γραμμές ή περιγράμματα [αλλιώς και τα δύο σε .gpkg, σε άλλες μορφές οι γραμμές].</translation>
    </message>
    <message>
        <source>Their middle lines</source>
        <translation>Οι μέσες γραμμές τους</translation>
    </message>
    <message>
        <source>Their outlines</source>
        <translation>Τα περιγράμματά τους</translation>
    </message>
    <message>
        <source>Map book for crews</source>
        <translation>Βιβλίο χαρτών για τα συνεργεία</translation>
    </message>
    <message>
        <source>Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, its ends, sizes, slope, cost and treatment, and what it is for.</source>
        <translation>Τυπώνει ένα σχέδιο ως PDF: μια επισκόπηση, έναν κατάλογο των τμημάτων και μια σελίδα για το καθένα με χάρτη σε στρογγυλή κλίμακα, τα άκρα του, τα μεγέθη, την κλίση, το κόστος και τη μεταχείριση, και σε τι χρησιμεύει.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the plan were written. Its segments alone do as well, without the vegetation; then the elevation is asked for.</source>
        <translation>Επιλέξτε τον φάκελο στον οποίο γράφτηκαν όλα τα αρχεία του σχεδίου. Αρκούν και μόνα τα τμήματά του, χωρίς τη βλάστηση· τότε ζητείται το υψόμετρο.</translation>
    </message>
    <message>
        <source>Segments with a page</source>
        <translation>Τμήματα με σελίδα</translation>
    </message>
    <message>
        <source>Folder of the run</source>
        <translation>Φάκελος της εκτέλεσης</translation>
    </message>
    <message>
        <source>Into which a plan or a comparison was written with all its files.</source>
        <translation>Στον οποίο γράφτηκε ένα σχέδιο ή μια σύγκριση με όλα τα αρχεία του.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Τίτλος</translation>
    </message>
    <message>
        <source>Title of the book [default: what the plan says of itself].</source>
        <translation>Τίτλος του βιβλίου [προεπιλογή: ό,τι λέει το σχέδιο για τον εαυτό του].</translation>
    </message>
    <message>
        <source>Date, as it is to be shown</source>
        <translation>Ημερομηνία, όπως θα φαίνεται</translation>
    </message>
    <message>
        <source>Date of the data or the print, shown as it is given.</source>
        <translation>Ημερομηνία των δεδομένων ή της εκτύπωσης, όπως δίνεται.</translation>
    </message>
    <message>
        <source>Roads to draw: lines or areas of any vector file.</source>
        <translation>Δρόμοι που σχεδιάζονται: γραμμές ή επιφάνειες οποιουδήποτε διανυσματικού αρχείου.</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw</source>
        <translation>Ποτάμια και λίμνες που σχεδιάζονται</translation>
    </message>
    <message>
        <source>Rivers and lakes to draw: lines or areas.</source>
        <translation>Ποτάμια και λίμνες που σχεδιάζονται: γραμμές ή επιφάνειες.</translation>
    </message>
    <message>
        <source>Most segments that get a page</source>
        <translation>Μέγιστο πλήθος τμημάτων με σελίδα</translation>
    </message>
    <message>
        <source>Segments that get a page, the first in order of construction; the list names all.</source>
        <translation>Τμήματα που παίρνουν σελίδα, τα πρώτα στη σειρά κατασκευής· ο κατάλογος τα ονομάζει όλα.</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Χαρτί</translation>
    </message>
    <message>
        <source>Size of the paper.</source>
        <translation>Μέγεθος του χαρτιού.</translation>
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
        <translation>ως τα τμήματά του (segments.gpkg)</translation>
    </message>
    <message>
        <source>Elevation on any grid, beside segments alone; the folder of a plan has its own.</source>
        <translation>Υψόμετρο σε οποιοδήποτε πλέγμα, αν δίνονται μόνο τμήματα· ο φάκελος ενός σχεδίου έχει το δικό του.</translation>
    </message>
    <message>
        <source>Shorter segments get no page [m]</source>
        <translation>Μικρότερα τμήματα δεν παίρνουν σελίδα [m]</translation>
    </message>
    <message>
        <source>Segments shorter than this have no page of their own [m].</source>
        <translation>Τμήματα μικρότερα από αυτό δεν έχουν δική τους σελίδα [m].</translation>
    </message>
    <message>
        <source>Upright pages</source>
        <translation>Όρθιες σελίδες</translation>
    </message>
    <message>
        <source>Upright pages, the texts under the map.</source>
        <translation>Όρθιες σελίδες, τα κείμενα κάτω από τον χάρτη.</translation>
    </message>
    <message>
        <source>Map book</source>
        <translation>Βιβλίο χαρτών</translation>
    </message>
    <message>
        <source>Files for crews</source>
        <translation>Αρχεία για τα συνεργεία</translation>
    </message>
    <message>
        <source>Write segments, breaks or compartments of a plan in the format of a crew.</source>
        <translation>Γράφει τα τμήματα, τις ζώνες ή τα διαμερίσματα ενός σχεδίου στη μορφή ενός συνεργείου.</translation>
    </message>
    <message>
        <source>The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, .zip for a Shapefile, .geojson for the web.</source>
        <translation>Η κατάληξη του αρχείου την επιλέγει: .kml για το Google Earth και τηλέφωνα, .gpx για συσκευές GPS, .dxf για σχέδια, .zip για Shapefile, .geojson για τον ιστό.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Στοιχεία</translation>
    </message>
    <message>
        <source>Segments, breaks or compartments of a plan (.gpkg)</source>
        <translation>Τμήματα, ζώνες ή διαμερίσματα ενός σχεδίου (.gpkg)</translation>
    </message>
    <message>
        <source>The segments.gpkg, breaks.gpkg or compartments.gpkg that a plan wrote.</source>
        <translation>Το segments.gpkg, breaks.gpkg ή compartments.gpkg που έγραψε ένα σχέδιο.</translation>
    </message>
    <message>
        <source>File for the crew</source>
        <translation>Αρχείο για το συνεργείο</translation>
    </message>
    <message>
        <source>Burn frequency</source>
        <translation>Συχνότητα καύσης</translation>
    </message>
    <message>
        <source>Let many fires start and tell how often each cell burns.</source>
        <translation>Αφήνει να αρχίσουν πολλές πυρκαγιές και λέει πόσο συχνά καίγεται κάθε κελί.</translation>
    </message>
    <message>
        <source>Fires with a duration need a network with times. With the same seed the fires are the same with and without breaks, so their difference is the breaks' work alone.</source>
        <translation>Οι πυρκαγιές με διάρκεια χρειάζονται δίκτυο με χρόνους. Με τον ίδιο σπόρο οι πυρκαγιές είναι ίδιες με και χωρίς ζώνες, άρα η διαφορά τους οφείλεται μόνο στις ζώνες.</translation>
    </message>
    <message>
        <source>Mean burnt share</source>
        <translation>Μέσο καμένο ποσοστό</translation>
    </message>
    <message>
        <source>Largest burnt share</source>
        <translation>Μέγιστο καμένο ποσοστό</translation>
    </message>
    <message>
        <source>Mean fire in hectares</source>
        <translation>Μέση πυρκαγιά σε εκτάρια</translation>
    </message>
    <message>
        <source>Largest fire in hectares</source>
        <translation>Μέγιστη πυρκαγιά σε εκτάρια</translation>
    </message>
    <message>
        <source>Cut cells: a raster, or own breaks as polygons or lines.</source>
        <translation>Κελιά που κόβονται: ψηφιδωτό, ή δικές σας ζώνες ως πολύγωνα ή γραμμές.</translation>
    </message>
    <message>
        <source>Roads, rivers and the like on ground that the network holds as fuel; they stop fire as "How often a barrier holds" says.</source>
        <translation>Δρόμοι, ποτάμια και παρόμοια σε έδαφος που το δίκτυο θεωρεί καύσιμη ύλη· σταματούν τη φωτιά όπως λέει το "Πόσο συχνά κρατά ένα εμπόδιο".</translation>
    </message>
    <message>
        <source>How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and sigma), uniform:2h,12h, or weather [default: until they end by themselves].</source>
        <translation>Πόσο διαρκούν οι πυρκαγιές: 8h, λίστα που παίρνουν με τη σειρά οι εκτελέσεις (4h,8h), lognormal:8h,0.7 (διάμεσος και σίγμα), uniform:2h,12h, ή weather [αλλιώς ώσπου να τελειώσουν μόνες τους].</translation>
    </message>
    <message>
        <source>How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, or as in 0.47:800 [default: always].</source>
        <translation>Πόσο συχνά κρατά ένα κομμάτι ζώνης σε μια εκτέλεση: ποσοστό (0.47 στο πεδίο), flame (κατά το πλάτος και την ένταση της φωτιάς, Wilson 1988) ή flame:flames (1.5 μήκη φλόγας)· τα κομμάτια έχουν 400 m, ή όπως στο 0.47:800 [αλλιώς πάντα].</translation>
    </message>
    <message>
        <source>Take "Fire breaks" as lines of this width, such as 12m, or of the width in that column; they may be narrower than a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].</source>
        <translation>Παίρνει τις "Αντιπυρικές ζώνες" ως γραμμές αυτού του πλάτους, π.χ. 12m, ή του πλάτους σε αυτή τη στήλη· μπορεί να είναι στενότερες από ένα κελί και σταματούν τη φωτιά ανάμεσα στα κελιά που χωρίζουν [αλλιώς οι γραμμές παίρνουν κάθε κελί που αγγίζουν].</translation>
    </message>
    <message>
        <source>What treated cells keep of their spread (kept.tif)</source>
        <translation>Τι κρατούν από την εξάπλωση τα κελιά μετά τον χειρισμό (kept.tif)</translation>
    </message>
    <message>
        <source>What each cell keeps of its spread probability once it is treated, in place of one "Share of the spread that a break lets through" for all: kept.tif of a plan with treatments.</source>
        <translation>Τι κρατά κάθε κελί από την πιθανότητα εξάπλωσής του μετά τον χειρισμό, αντί για ένα "Ποσοστό της εξάπλωσης που αφήνει να περάσει μια ζώνη" για όλα: kept.tif ενός σχεδίου με χειρισμούς.</translation>
    </message>
    <message>
        <source>Side of the windows in which a large map is read [cells]</source>
        <translation>Πλευρά των παραθύρων στα οποία διαβάζεται ένας μεγάλος χάρτης [κελιά]</translation>
    </message>
    <message>
        <source>Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire needs it, so that maps larger than the memory can burn; the fires are the same.</source>
        <translation>Διαβάζει τον χάρτη σε παράθυρα αυτής της πλευράς (δύναμη του δύο, π.χ. 512) γύρω από κάθε πυρκαγιά, μεγαλύτερα όπου χρειάζεται, ώστε να καίγονται και χάρτες μεγαλύτεροι από τη μνήμη· οι πυρκαγιές είναι οι ίδιες.</translation>
    </message>
    <message>
        <source>Times for the folder of arrival times, such as 2h,4h</source>
        <translation>Χρόνοι για τον φάκελο των χρόνων άφιξης, π.χ. 2h,4h</translation>
    </message>
    <message>
        <source>Times for "Folder for arrival times".</source>
        <translation>Χρόνοι για το "Φάκελος για χρόνους άφιξης".</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes [hectares]</source>
        <translation>Όρια των κλάσεων μεγέθους πυρκαγιάς [εκτάρια]</translation>
    </message>
    <message>
        <source>Limits of the classes of fire sizes for "Folder for arrival times", in hectares.</source>
        <translation>Όρια των κλάσεων μεγέθους πυρκαγιάς για το "Φάκελος για χρόνους άφιξης", σε εκτάρια.</translation>
    </message>
    <message>
        <source>Flame lengths for the folder of arrival times [m]</source>
        <translation>Μήκη φλόγας για τον φάκελο των χρόνων άφιξης [m]</translation>
    </message>
    <message>
        <source>Flame lengths for "Folder for arrival times", in metres; left out if the network knows no heat.</source>
        <translation>Μήκη φλόγας για το "Φάκελος για χρόνους άφιξης", σε μέτρα· παραλείπονται αν το δίκτυο δεν γνωρίζει θερμότητα.</translation>
    </message>
    <message>
        <source>Fire sizes</source>
        <translation>Μεγέθη πυρκαγιών</translation>
    </message>
    <message>
        <source>Folder for arrival times, isochrones and more</source>
        <translation>Φάκελος για χρόνους άφιξης, ισόχρονες και άλλα</translation>
    </message>
    <message>
        <source>Judge existing breaks</source>
        <translation>Αξιολόγηση υπαρχουσών ζωνών</translation>
    </message>
    <message>
        <source>Tell what each existing fire break is worth, and which gap between breaks matters most.</source>
        <translation>Λέει πόσο αξίζει κάθε υπάρχουσα αντιπυρική ζώνη και ποιο κενό ανάμεσα στις ζώνες μετρά περισσότερο.</translation>
    </message>
    <message>
        <source>The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are the work of that break alone. The same break at random places stands beside it. The network must hold the fuel that lies on the breaks.</source>
        <translation>Οι ίδιες πυρκαγιές καίνε με όλες τις ζώνες, χωρίς καθεμία τους και με κάθε κενό κλειστό, άρα οι διαφορές οφείλονται μόνο σε εκείνη τη ζώνη. Δίπλα της βρίσκεται η ίδια ζώνη σε τυχαίες θέσεις. Το δίκτυο πρέπει να περιέχει την καύσιμη ύλη που βρίσκεται πάνω στις ζώνες.</translation>
    </message>
    <message>
        <source>Longest gap that is looked at [m]</source>
        <translation>Μεγαλύτερο κενό που εξετάζεται [m]</translation>
    </message>
    <message>
        <source>Length of the longest gap that is looked at, in metres.</source>
        <translation>Μήκος του μεγαλύτερου κενού που εξετάζεται, σε μέτρα.</translation>
    </message>
    <message>
        <source>Most gaps that are looked at</source>
        <translation>Μέγιστος αριθμός κενών που εξετάζονται</translation>
    </message>
    <message>
        <source>Number of gaps looked at, the shortest.</source>
        <translation>Αριθμός κενών που εξετάζονται, τα μικρότερα.</translation>
    </message>
    <message>
        <source>Random places to compare each break with</source>
        <translation>Τυχαίες θέσεις με τις οποίες συγκρίνεται κάθε ζώνη</translation>
    </message>
    <message>
        <source>Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.</source>
        <translation>Αριθμός τυχαίων θέσεων όπου δοκιμάζονται και κάθε ζώνη και κάθε κενό, για σύγκριση· 0 τις παραλείπει.</translation>
    </message>
    <message>
        <source>Breaks with what each is worth, and gaps with what closing them saves</source>
        <translation>Ζώνες με την αξία της καθεμίας, και κενά με όσα σώζει το κλείσιμό τους</translation>
    </message>
    <message>
        <source>What each break is worth</source>
        <translation>Πόσο αξίζει κάθε ζώνη</translation>
    </message>
    <message>
        <source>What closing each gap saves</source>
        <translation>Πόσα σώζει το κλείσιμο κάθε κενού</translation>
    </message>
    <message>
        <source>What stands and what is missing, in words</source>
        <translation>Τι υπάρχει και τι λείπει, με λόγια</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Εκτίμηση</translation>
    </message>
    <message>
        <source>Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.</source>
        <translation>Κρίνει μεθόδους κατάταξης: μέσος, εκατοστημόριο 90 % και μέγιστο του καμένου ποσοστού σε κάθε προϋπολογισμό.</translation>
    </message>
    <message>
        <source>All rankings meet the same fires, and each plan is made for its budget.</source>
        <translation>Όλες οι μέθοδοι αντιμετωπίζουν τις ίδιες πυρκαγιές, και κάθε σχέδιο γίνεται για τον προϋπολογισμό του.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Μέθοδοι</translation>
    </message>
    <message>
        <source>Methods to hold against each other; all rankings are described below.</source>
        <translation>Μέθοδοι που συγκρίνονται μεταξύ τους· όλες οι μέθοδοι κατάταξης περιγράφονται παρακάτω.</translation>
    </message>
    <message>
        <source>Ranking to test against</source>
        <translation>Μέθοδος με την οποία γίνεται ο έλεγχος</translation>
    </message>
    <message>
        <source>Ranking that the others are tested against.</source>
        <translation>Μέθοδος με την οποία ελέγχονται οι άλλες.</translation>
    </message>
    <message>
        <source>Budgets, such as 5%, 10%</source>
        <translation>Προϋπολογισμοί, π.χ. 5%, 10%</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: 0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</source>
        <translation>Πόσο θα κοπεί, χωρισμένο με κόμματα: ποσοστά της καύσιμης ύλης όπως 5% ή 0.05, ή εκτάσεις όπως 20ha [αλλιώς 0 έως 0.4 σε βήματα των 0.01· όπου κάθε προϋπολογισμός καίγεται εκ νέου, με χρόνο ή με ζώνες που αστοχούν, 0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2].</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.</source>
        <translation>Προσημασμένες τάξεις του Wilcoxon ανά ζεύγη, άθροισμα τάξεων του Wilcoxon για ανεξάρτητες εκτελέσεις, ή t ανά ζεύγη.</translation>
    </message>
    <message>
        <source>Wilcoxon's signed-rank test of pairs</source>
        <translation>Έλεγχος προσημασμένων τάξεων του Wilcoxon, ανά ζεύγη</translation>
    </message>
    <message>
        <source>Wilcoxon's rank-sum test of independent runs</source>
        <translation>Έλεγχος αθροίσματος τάξεων του Wilcoxon, ανεξάρτητες εκτελέσεις</translation>
    </message>
    <message>
        <source>Student's t-test of pairs</source>
        <translation>Έλεγχος t του Student, ανά ζεύγη</translation>
    </message>
    <message>
        <source>Significance threshold</source>
        <translation>Κατώφλι σημαντικότητας</translation>
    </message>
    <message>
        <source>Significance threshold.</source>
        <translation>Κατώφλι σημαντικότητας.</translation>
    </message>
    <message>
        <source>Burnt share and significance of every ranking at every budget</source>
        <translation>Καμένο ποσοστό και σημαντικότητα κάθε μεθόδου σε κάθε προϋπολογισμό</translation>
    </message>
    <message>
        <source>Cells burnt in every run, from which each p-value can be found again</source>
        <translation>Καμένα κελιά σε κάθε εκτέλεση, από τα οποία ξαναβρίσκεται κάθε τιμή p</translation>
    </message>
    <message>
        <source>Curves of the burnt share</source>
        <translation>Καμπύλες του καμένου ποσοστού</translation>
    </message>
    <message>
        <source>Curves of the burnt share, to scale</source>
        <translation>Καμπύλες του καμένου ποσοστού, διανυσματικές</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Σύγκριση</translation>
    </message>
    <message>
        <source>Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with intervals.</source>
        <translation>Συγκρίνει σχέδια: αναμενόμενη καμένη έκταση, χαμένη αξία, χειρότερες πυρκαγιές και εκτάρια που σώζονται ανά εκτάριο κοπής, με διαστήματα.</translation>
    </message>
    <message>
        <source>The fires are fresh: no plan was designed with them, and all burn in the same ones.</source>
        <translation>Οι πυρκαγιές είναι νέες: κανένα σχέδιο δεν έγινε με αυτές, και όλα καίγονται στις ίδιες.</translation>
    </message>
    <message>
        <source>Lines: walls as wide as a cell and at most 30 m, of which plans are made by default</source>
        <translation>Γραμμές: τοίχοι πλάτους ενός κελιού και το πολύ 30 m, από τους οποίους γίνονται τα σχέδια όταν δεν ορίζεται τίποτα</translation>
    </message>
    <message>
        <source>How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.</source>
        <translation>Πόσο θα κοπεί, χωρισμένο με κόμματα: ποσοστά της καύσιμης ύλης όπως 5% ή 0.05, ή εκτάσεις όπως 20ha.</translation>
    </message>
    <message>
        <source>Shares that breaks let through, separated by commas</source>
        <translation>Ποσοστά που αφήνουν να περάσουν οι ζώνες, χωρισμένα με κόμματα</translation>
    </message>
    <message>
        <source>Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.</source>
        <translation>Ποσοστά της πιθανότητας εξάπλωσής του που κρατά ένα κελί μετά τον χειρισμό, χωρισμένα με κόμματα· 0 είναι τέλειο.</translation>
    </message>
    <message>
        <source>Fires expected until the breaks have grown back</source>
        <translation>Πυρκαγιές που αναμένονται ώσπου να ξανακλείσουν οι ζώνες</translation>
    </message>
    <message>
        <source>Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so often when it is held against what they cost.</source>
        <translation>Αριθμός πυρκαγιών που συναντούν τις ζώνες πριν ξανακλείσουν· όσα σώζουν σε μία πυρκαγιά μετρούν τόσες φορές όταν συγκρίνονται με όσα κοστίζουν.</translation>
    </message>
    <message>
        <source>The comparison on one page; opens in any browser</source>
        <translation>Η σύγκριση σε μία σελίδα· ανοίγει σε κάθε φυλλομετρητή</translation>
    </message>
    <message>
        <source>Every plan at every budget and leak, with intervals</source>
        <translation>Κάθε σχέδιο σε κάθε προϋπολογισμό και διαρροή, με διαστήματα</translation>
    </message>
    <message>
        <source>Curves of the plans</source>
        <translation>Καμπύλες των σχεδίων</translation>
    </message>
    <message>
        <source>Curves of the plans, to scale</source>
        <translation>Καμπύλες των σχεδίων, διανυσματικές</translation>
    </message>
    <message>
        <source>What each step of each plan costs and saves</source>
        <translation>Τι κοστίζει και τι σώζει κάθε βήμα κάθε σχεδίου</translation>
    </message>
    <message>
        <source>Saved against paid, and where the next hectare stops paying</source>
        <translation>Τι σώζεται έναντι του τι πληρώνεται, και πού παύει να αποδίδει το επόμενο εκτάριο</translation>
    </message>
    <message>
        <source>Validate against a scar</source>
        <translation>Έλεγχος με καμένη έκταση</translation>
    </message>
    <message>
        <source>Hold a simulated fire against the area that burnt, beside fires that know nothing.</source>
        <translation>Συγκρίνει μια προσομοιωμένη πυρκαγιά με την έκταση που κάηκε, δίπλα σε πυρκαγιές που δεν ξέρουν τίποτα.</translation>
    </message>
    <message>
        <source>Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.</source>
        <translation>Δείκτης Sørensen, IoU, IoU της αύξησης μόνο, μέγεθος, βαθμός Brier και αξιοπιστία δίνονται για την προσομοιωμένη πυρκαγιά και για τα μηδενικά μοντέλα: καμία αύξηση, ίση απόσταση στην καύσιμη ύλη, έλλειψη στον άνεμο.</translation>
    </message>
    <message>
        <source>Observed hectares</source>
        <translation>Παρατηρημένα εκτάρια</translation>
    </message>
    <message>
        <source>Simulated hectares</source>
        <translation>Προσομοιωμένα εκτάρια</translation>
    </message>
    <message>
        <source>Area that burnt</source>
        <translation>Καμένη έκταση</translation>
    </message>
    <message>
        <source>Perimeter of the fire as polygons, or a raster above 0 where it burnt.</source>
        <translation>Περίμετρος της πυρκαγιάς ως πολύγωνα, ή ψηφιδωτό πάνω από 0 όπου κάηκε.</translation>
    </message>
    <message>
        <source>Where the fire was first seen</source>
        <translation>Πού φάνηκε πρώτα η φωτιά</translation>
    </message>
    <message>
        <source>Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.</source>
        <translation>Πού φάνηκε πρώτα η φωτιά: σημεία, ή πολύγωνα που ήδη καίγονταν (κάθε διανυσματικό αρχείο), ή ψηφιδωτό.</translation>
    </message>
    <message>
        <source>How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.</source>
        <translation>Πόση ώρα εξαπλωνόταν η πυρκαγιά, π.χ. 3h· lognormal:3h,0.5 (διάμεσος, σίγμα) όπου δεν είναι καλά γνωστό.</translation>
    </message>
    <message>
        <source>Number of simulated fires.</source>
        <translation>Αριθμός προσομοιωμένων πυρκαγιών.</translation>
    </message>
    <message>
        <source>Scores of the simulated fire and of the null models</source>
        <translation>Βαθμοί της προσομοιωμένης πυρκαγιάς και των μηδενικών μοντέλων</translation>
    </message>
    <message>
        <source>How often cells burnt, by the probability forecast</source>
        <translation>Πόσο συχνά κάηκαν τα κελιά, κατά την προβλεπόμενη πιθανότητα</translation>
    </message>
    <message>
        <source>Share of the simulated fires in which each cell burns</source>
        <translation>Ποσοστό των προσομοιωμένων πυρκαγιών όπου καίγεται κάθε κελί</translation>
    </message>
    <message>
        <source>Picture of the simulated fire over the scar, with the reliability</source>
        <translation>Εικόνα της προσομοιωμένης πυρκαγιάς πάνω στην καμένη έκταση, με την αξιοπιστία</translation>
    </message>
    <message>
        <source>Calibrate on observed fires</source>
        <translation>Βαθμονόμηση με παρατηρημένες πυρκαγιές</translation>
    </message>
    <message>
        <source>Fit the rate of spread, durations and spread probability to the fires of a region.</source>
        <translation>Προσαρμόζει ταχύτητα εξάπλωσης, διάρκειες και πιθανότητα εξάπλωσης στις πυρκαγιές μιας περιοχής.</translation>
    </message>
    <message>
        <source>The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in which they burn. More numbers than the fires can tell are refused.</source>
        <translation>Οι πυρκαγιές είναι πολύγωνα ή πίνακας με τα μεγέθη τους και, αν είναι γνωστές, τις ημέρες τους· ο καιρός λέει τους ανέμους στους οποίους καίνε. Απορρίπτονται περισσότεροι αριθμοί από όσους μπορούν να πουν οι πυρκαγιές.</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Πυρκαγιές</translation>
    </message>
    <message>
        <source>Numbers fitted</source>
        <translation>Αριθμοί που προσαρμόστηκαν</translation>
    </message>
    <message>
        <source>Observed fires with sizes and days</source>
        <translation>Παρατηρημένες πυρκαγιές με μεγέθη και ημέρες</translation>
    </message>
    <message>
        <source>Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.</source>
        <translation>Πολύγωνα ή πίνακας (CSV) των πυρκαγιών μιας περιοχής, με τα μεγέθη τους σε εκτάρια και, αν είναι γνωστές, τις ημέρες τους.</translation>
    </message>
    <message>
        <source>What to fit: rate, duration, p0</source>
        <translation>Τι προσαρμόζεται: rate, duration, p0</translation>
    </message>
    <message>
        <source>What to fit: rate, duration and p0, separated by commas [default: rate and duration; of fewer than three scars the rate alone].</source>
        <translation>Τι προσαρμόζεται: rate, duration και p0, χωρισμένα με κόμματα [αλλιώς rate και duration· με λιγότερες από τρεις καμένες εκτάσεις μόνο rate].</translation>
    </message>
    <message>
        <source>Smallest fire that counts [hectares]</source>
        <translation>Μικρότερη πυρκαγιά που μετράει [εκτάρια]</translation>
    </message>
    <message>
        <source>Fires of fewer hectares do not count: small ones are often not mapped.</source>
        <translation>Πυρκαγιές με λιγότερα εκτάρια δεν μετρούν: οι μικρές συχνά δεν χαρτογραφούνται.</translation>
    </message>
    <message>
        <source>How likely a fire starts in each cell, relative to the others [default: everywhere alike].</source>
        <translation>Πόσο πιθανό είναι να αρχίσει πυρκαγιά σε κάθε κελί, σε σχέση με τα άλλα [αλλιώς παντού το ίδιο].</translation>
    </message>
    <message>
        <source>Column with the size in hectares</source>
        <translation>Στήλη με το μέγεθος σε εκτάρια</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the size in hectares [default: found by name].</source>
        <translation>Στήλη των "Παρατηρημένες πυρκαγιές με μεγέθη και ημέρες" με το μέγεθος σε εκτάρια [αλλιώς βρίσκεται από το όνομα].</translation>
    </message>
    <message>
        <source>Column with the first day</source>
        <translation>Στήλη με την πρώτη ημέρα</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the first day [default: found by name].</source>
        <translation>Στήλη των "Παρατηρημένες πυρκαγιές με μεγέθη και ημέρες" με την πρώτη ημέρα [αλλιώς βρίσκεται από το όνομα].</translation>
    </message>
    <message>
        <source>Column with the last day</source>
        <translation>Στήλη με την τελευταία ημέρα</translation>
    </message>
    <message>
        <source>Column of "Observed fires with sizes and days" with the last day [default: found by name].</source>
        <translation>Στήλη των "Παρατηρημένες πυρκαγιές με μεγέθη και ημέρες" με την τελευταία ημέρα [αλλιώς βρίσκεται από το όνομα].</translation>
    </message>
    <message>
        <source>Time of spread on each day of a fire [hours]</source>
        <translation>Χρόνος εξάπλωσης σε κάθε ημέρα πυρκαγιάς [ώρες]</translation>
    </message>
    <message>
        <source>Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.</source>
        <translation>Ώρες που εξαπλώνεται μια πυρκαγιά σε καθεμία από τις ημέρες της· παραδοχή που ξεχωρίζει ταχύτητες από διάρκειες.</translation>
    </message>
    <message>
        <source>Longest simulated fire, such as 200h</source>
        <translation>Μεγαλύτερη διάρκεια προσομοιωμένης πυρκαγιάς, π.χ. 200h</translation>
    </message>
    <message>
        <source>No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].</source>
        <translation>Καμία πυρκαγιά δεν εξαπλώνεται περισσότερο [αλλιώς όσες ολόκληρες ημέρες η μεγαλύτερη παρατηρημένη πυρκαγιά, ή 200h].</translation>
    </message>
    <message>
        <source>Parameter of the spread model that stays as it is, e.g. moisture=0.06; several are separated by ;.</source>
        <translation>Παράμετρος του μοντέλου εξάπλωσης που μένει όπως είναι, π.χ. moisture=0.06· πολλές χωρίζονται με ;.</translation>
    </message>
    <message>
        <source>Calibration, which other forms take</source>
        <translation>Βαθμονόμηση, που τη δέχονται άλλες φόρμες</translation>
    </message>
    <message>
        <source>What is told of each fire</source>
        <translation>Όσα λέγονται για κάθε πυρκαγιά</translation>
    </message>
    <message>
        <source>Report of a run</source>
        <translation>Αναφορά μιας εκτέλεσης</translation>
    </message>
    <message>
        <source>Show a plan or a comparison on one page: map, segments, curve, assumptions, files.</source>
        <translation>Δείχνει ένα σχέδιο ή μια σύγκριση σε μία σελίδα: χάρτης, τμήματα, καμπύλη, παραδοχές, αρχεία.</translation>
    </message>
    <message>
        <source>Choose the folder into which all files of the run were written. The page opens in any browser without a network. Its links lead to files beside the page, so write it into that folder.</source>
        <translation>Επιλέξτε τον φάκελο όπου γράφτηκαν όλα τα αρχεία της εκτέλεσης. Η σελίδα ανοίγει σε κάθε φυλλομετρητή χωρίς δίκτυο. Οι σύνδεσμοί της οδηγούν σε αρχεία δίπλα στη σελίδα· γράψτε τη λοιπόν σε αυτόν τον φάκελο.</translation>
    </message>
    <message>
        <source>The run on one page</source>
        <translation>Η εκτέλεση σε μία σελίδα</translation>
    </message>
    <message>
        <source>{} was not made: there is nothing to put in it.</source>
        <translation>Το {} δεν έγινε: δεν υπάρχει τίποτα να μπει σε αυτό.</translation>
    </message>
    <message>
        <source>Stopped; no output was written.</source>
        <translation>Διακόπηκε· δεν γράφτηκε κανένα αποτέλεσμα.</translation>
    </message>
    <message>
        <source>Report: {} (open it from the Results Viewer)</source>
        <translation>Αναφορά: {} (ανοίγει από την προβολή αποτελεσμάτων)</translation>
    </message>
    <message>
        <source>[not chosen]</source>
        <translation>[καμία επιλογή]</translation>
    </message>
    <message>
        <source>{} holds {}; only a GeoPackage can hold {} as well.</source>
        <translation>Το {} περιέχει {}· μόνο ένα GeoPackage μπορεί να περιέχει και {}.</translation>
    </message>
    <message>
        <source>The layer {} cannot be read as cells of a raster.</source>
        <translation>Το επίπεδο {} δεν διαβάζεται ως κελιά ψηφιδωτού.</translation>
    </message>
    <message>
        <source>An extent needs the CRS of the grid; choose it beside the extent (CRS).</source>
        <translation>Η έκταση χρειάζεται το ΣΑΣ του καννάβου· επιλέξτε το δίπλα στην έκταση (ΣΑΣ).</translation>
    </message>
    <message>
        <source>Making the engine of Firebreak</source>
        <translation>Δημιουργία της μηχανής του Firebreak</translation>
    </message>
    <message>
        <source>firebreak_gis {} is ready.</source>
        <translation>Το firebreak_gis {} είναι έτοιμο.</translation>
    </message>
    <message>
        <source>firebreak_gis {} answers: {} ({})</source>
        <translation>Το firebreak_gis {} απαντά: {} ({})</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Μηχανή</translation>
    </message>
    <message>
        <source>Python with firebreak_gis, or the firebreak program</source>
        <translation>Python με firebreak_gis, ή το πρόγραμμα firebreak</translation>
    </message>
    <message>
        <source>empty: found by itself</source>
        <translation>κενό: βρίσκεται μόνο του</translation>
    </message>
    <message>
        <source>Python or program</source>
        <translation>Python ή πρόγραμμα</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Έλεγχος μηχανής</translation>
    </message>
    <message>
        <source>Make an engine</source>
        <translation>Δημιουργία μηχανής</translation>
    </message>
    <message>
        <source>Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The Python of QGIS is left alone, and an engine made before stays until the new one answers. Nothing is installed until you press the button.</source>
        <translation>Δημιουργεί περιβάλλον Python στο προφίλ σας του QGIS, περίπου 900 MB, και εγκαθιστά σε αυτό το firebreak_gis: από το ευρετήριο πακέτων (μέσω του διακομιστή μεσολάβησης του QGIS), ή από τη διαδρομή ενός κλώνου ή ενός wheel. Η Python του QGIS μένει ανέγγιχτη, και μια προηγούμενη μηχανή μένει ώσπου να απαντήσει η νέα. Τίποτα δεν εγκαθίσταται πριν πατήσετε το κουμπί.</translation>
    </message>
    <message>
        <source>empty: the newest of 3.11 to 3.13 found</source>
        <translation>κενό: η νεότερη από 3.11 έως 3.13 που θα βρεθεί</translation>
    </message>
    <message>
        <source>Python to make it from</source>
        <translation>Python από την οποία δημιουργείται</translation>
    </message>
    <message>
        <source>A name in the index, or the path of a clone or a wheel.</source>
        <translation>Ένα όνομα του ευρετηρίου, ή η διαδρομή ενός κλώνου ή ενός wheel.</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Πακέτο</translation>
    </message>
    <message>
        <source>Make engine</source>
        <translation>Δημιουργία</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>Firebreak settings…</source>
        <translation>Ρυθμίσεις του Firebreak…</translation>
    </message>
    <message>
        <source>Firebreak</source>
        <translation>Firebreak</translation>
    </message>
    <message>
        <source>Firebreak (plan forest fire breaks)</source>
        <translation>Firebreak (σχεδιασμός αντιπυρικών ζωνών στο δάσος)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Παράμετροι</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Αποτελέσματα</translation>
    </message>
</context>
</TS>
