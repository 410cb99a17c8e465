<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>AxisUnits</name>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>N s/m</source>
        <translation>N s/m</translation>
    </message>
    <message>
        <source>N/A</source>
        <translation>N/A</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>V s/m</source>
        <translation>V s/m</translation>
    </message>
    <message>
        <source>A s/m</source>
        <translation>A s/m</translation>
    </message>
    <message>
        <source>A/m</source>
        <translation>A/m</translation>
    </message>
    <message>
        <source>A s²/m</source>
        <translation>A s²/m</translation>
    </message>
    <message>
        <source>mNm</source>
        <translation>mNm</translation>
    </message>
    <message>
        <source>µNm s/rad</source>
        <translation>µNm s/rad</translation>
    </message>
    <message>
        <source>Nm/A</source>
        <translation>Nm/A</translation>
    </message>
    <message>
        <source>g cm²</source>
        <translation>g cm²</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>V s/rad</source>
        <translation>V s/rad</translation>
    </message>
    <message>
        <source>A s/rad</source>
        <translation>A s/rad</translation>
    </message>
    <message>
        <source>A/rad</source>
        <translation>A/rad</translation>
    </message>
    <message>
        <source>A s²/rad</source>
        <translation>A s²/rad</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>rechtsherum</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>linksherum</translation>
    </message>
    <message>
        <source>back</source>
        <translation>rück</translation>
    </message>
    <message>
        <source>fwd</source>
        <translation>vor</translation>
    </message>
    <message>
        <source>cw</source>
        <translation>re</translation>
    </message>
    <message>
        <source>ccw</source>
        <translation>li</translation>
    </message>
</context>
<context>
    <name>BoardTuning</name>
    <message>
        <source>bench file</source>
        <translation>Prüfstandsdatei</translation>
    </message>
    <message>
        <source>name plate</source>
        <translation>Typenschild</translation>
    </message>
    <message>
        <source>identification</source>
        <translation>Identifikation</translation>
    </message>
</context>
<context>
    <name>ColumnWords</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>linear speed</source>
        <translation>Lineargeschwindigkeit</translation>
    </message>
    <message>
        <source>motor voltage</source>
        <translation>Motorspannung</translation>
    </message>
    <message>
        <source>duty cycle</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>supply voltage</source>
        <translation>Versorgungsspannung</translation>
    </message>
    <message>
        <source>winding temperature</source>
        <translation>Wicklungstemperatur</translation>
    </message>
    <message>
        <source>angle asked for</source>
        <translation>Sollwinkel</translation>
    </message>
    <message>
        <source>position asked for</source>
        <translation>Solllage</translation>
    </message>
    <message>
        <source>speed asked for</source>
        <translation>Sollgeschwindigkeit</translation>
    </message>
    <message>
        <source>linear speed asked for</source>
        <translation>lineare Sollgeschwindigkeit</translation>
    </message>
    <message>
        <source>current asked for</source>
        <translation>Sollstrom</translation>
    </message>
    <message>
        <source>disturbance torque</source>
        <translation>Störmoment</translation>
    </message>
    <message>
        <source>disturbance force</source>
        <translation>Störkraft</translation>
    </message>
    <message>
        <source>index pulse</source>
        <translation>Indeximpuls</translation>
    </message>
    <message>
        <source>windings on</source>
        <translation>Wicklungen bestromt</translation>
    </message>
</context>
<context>
    <name>ComparisonWords</name>
    <message>
        <source>%1 of %2, by chance %3</source>
        <translation>%1 von %2, zufällig %3</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Mean change</source>
        <translation>Mittlere Änderung</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Bins beyond</source>
        <translation>Abschnitte darüber</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>New: %1</source>
        <translation>Neu: %1</translation>
    </message>
    <message>
        <source>No longer found: %1</source>
        <translation>Nicht mehr gefunden: %1</translation>
    </message>
    <message>
        <source>The runs are of two motors.</source>
        <translation>Die Läufe sind von zwei Motoren.</translation>
    </message>
    <message>
        <source>Nothing has changed beyond the 95 % intervals</source>
        <translation>Nichts hat sich über die 95-%-Intervalle hinaus geändert</translation>
    </message>
    <message>
        <source>Changed beyond the 95 % intervals</source>
        <translation>Über die 95-%-Intervalle hinaus geändert</translation>
    </message>
    <message>
        <source>Within them</source>
        <translation>Innerhalb der Intervalle</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Difference (RMS)</source>
        <translation>Unterschied (Effektivwert)</translation>
    </message>
    <message>
        <source>Laid over each other from their beginnings</source>
        <translation>Von ihrem Beginn an übereinandergelegt</translation>
    </message>
    <message>
        <source>Over the %1 s that both last; the report has pictures.</source>
        <translation>Über die %1 s, die beide dauern; der Bericht hat Bilder.</translation>
    </message>
</context>
<context>
    <name>Duration</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>IdentifyStep</name>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>moves nothing, windings open</source>
        <translation>bewegt nichts, Wicklungen offen</translation>
    </message>
    <message>
        <source>Wiring</source>
        <translation>Verdrahtung</translation>
    </message>
    <message>
        <source>a few small pulses, a tenth of a turn at most</source>
        <translation>kleine Impulse, höchstens 1/10 Umdrehung</translation>
    </message>
    <message>
        <source>Winding</source>
        <translation>Wicklung</translation>
    </message>
    <message>
        <source>stands, until each ramp just moves it</source>
        <translation>steht, bis jede Rampe ihn gerade bewegt</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>turns both ways, up to half the supply, 24 s</source>
        <translation>dreht beide Wege, bis halbe Spannung, 24 s</translation>
    </message>
    <message>
        <source>Reversal</source>
        <translation>Umkehr</translation>
    </message>
    <message>
        <source>swings to and fro by constant current, 5 s</source>
        <translation>schwingt mit festem Strom hin und her, 5 s</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Brücke</translation>
    </message>
    <message>
        <source>moves nothing: all tests together</source>
        <translation>bewegt nichts: alle Versuche zusammen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>moves nothing: what the current&apos;s scale is worth</source>
        <translation>bewegt nichts: Wert des Strommaßstabs</translation>
    </message>
    <message>
        <source>a few small pulses, millimetres at most</source>
        <translation>einige kleine Impulse, höchstens Millimeter</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>feels for both ends of the travel, 20 s</source>
        <translation>tastet nach beiden Enden des Wegs, 20 s</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Hübe</translation>
    </message>
    <message>
        <source>strokes to and fro by voltage, 12 s</source>
        <translation>Hübe hin und her mit Spannung, 12 s</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Ω</source>
        <translation>Ω</translation>
    </message>
    <message>
        <source>Kf</source>
        <translation>Kf</translation>
    </message>
    <message>
        <source>Kt</source>
        <translation>Kt</translation>
    </message>
    <message>
        <source>N/A</source>
        <translation>N/A</translation>
    </message>
    <message>
        <source>mNm/A</source>
        <translation>mNm/A</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>g cm²</source>
        <translation>g cm²</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>mA</source>
        <translation>mA</translation>
    </message>
    <message>
        <source>L/R</source>
        <translation>L/R</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>mNm</source>
        <translation>mNm</translation>
    </message>
    <message>
        <source>dead zone</source>
        <translation>Totzone</translation>
    </message>
    <message>
        <source>mV</source>
        <translation>mV</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>N s/m</source>
        <translation>N s/m</translation>
    </message>
    <message>
        <source>µNm s/rad</source>
        <translation>µNm s/rad</translation>
    </message>
    <message>
        <source>Ke</source>
        <translation>Ke</translation>
    </message>
    <message>
        <source>V s/m</source>
        <translation>V s/m</translation>
    </message>
    <message>
        <source>mV s/rad</source>
        <translation>mV s/rad</translation>
    </message>
</context>
<context>
    <name>LiveChannel</name>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschw.</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Störgröße</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>mNm</source>
        <translation>mNm</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Versorgung</translation>
    </message>
    <message>
        <source>Position asked for</source>
        <translation>Verlangte Position</translation>
    </message>
    <message>
        <source>Angle asked for</source>
        <translation>Verlangter Winkel</translation>
    </message>
    <message>
        <source>Speed asked for</source>
        <translation>Verlangte Drehzahl</translation>
    </message>
    <message>
        <source>Current asked for</source>
        <translation>Verlangter Strom</translation>
    </message>
</context>
<context>
    <name>MapCurve</name>
    <message>
        <source> ± %1</source>
        <translation> ± %1</translation>
    </message>
    <message>
        <source> (95 %)</source>
        <translation> (95 %)</translation>
    </message>
    <message>
        <source>, outlier</source>
        <translation>, Ausreißer</translation>
    </message>
</context>
<context>
    <name>MapGhost</name>
    <message>
        <source>no difference</source>
        <translation>kein Unterschied</translation>
    </message>
    <message>
        <source>now − earlier</source>
        <translation>jetzt − früher</translation>
    </message>
    <message>
        <source>%1, earlier</source>
        <translation>%1, früher</translation>
    </message>
</context>
<context>
    <name>MapView</name>
    <message>
        <source>%1, pass %2</source>
        <translation>%1, Durchgang %2</translation>
    </message>
    <message>
        <source>%1, turn %2</source>
        <translation>%1, Umdr. %2</translation>
    </message>
    <message>
        <source>breakaway force (%1)</source>
        <translation>Losbrechkraft (%1)</translation>
    </message>
    <message>
        <source>breakaway torque (%1)</source>
        <translation>Losbrechmoment (%1)</translation>
    </message>
    <message>
        <source>Coulomb friction (%1)</source>
        <translation>Coulomb-Reibung (%1)</translation>
    </message>
    <message>
        <source>viscous coefficient (%1)</source>
        <translation>viskoser Beiwert (%1)</translation>
    </message>
    <message>
        <source>static friction (%1)</source>
        <translation>Haftreibung (%1)</translation>
    </message>
    <message>
        <source>position force (%1)</source>
        <translation>Lagekraft (%1)</translation>
    </message>
    <message>
        <source>position torque (%1)</source>
        <translation>Lagemoment (%1)</translation>
    </message>
    <message>
        <source>position force</source>
        <translation>Lagekraft</translation>
    </message>
    <message>
        <source>position torque</source>
        <translation>Lagemoment</translation>
    </message>
    <message>
        <source>Breakaway, pass by pass</source>
        <translation>Losbrechen, Durchgang für Durchgang</translation>
    </message>
    <message>
        <source>Breakaway, turn by turn</source>
        <translation>Losbrechen, Umdrehung für Umdrehung</translation>
    </message>
    <message>
        <source>Static friction, mean</source>
        <translation>Haftreibung, Mittel</translation>
    </message>
    <message>
        <source>Coulomb friction</source>
        <translation>Coulomb-Reibung</translation>
    </message>
    <message>
        <source>Viscous coefficient</source>
        <translation>Viskoser Beiwert</translation>
    </message>
    <message>
        <source>Total at the map&apos;s speed</source>
        <translation>Gesamt bei der Geschwindigkeit der Karte</translation>
    </message>
    <message>
        <source>Position force</source>
        <translation>Lagekraft</translation>
    </message>
    <message>
        <source>Position torque</source>
        <translation>Lagemoment</translation>
    </message>
    <message>
        <source>Breakaway</source>
        <translation>Losbrechen</translation>
    </message>
    <message>
        <source>Static</source>
        <translation>Haft</translation>
    </message>
    <message>
        <source>Coulomb</source>
        <translation>Coulomb</translation>
    </message>
    <message>
        <source>Viscous</source>
        <translation>Viskos</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Run the breakaway sweep first</source>
        <translation>Erst die Losbrechfahrt fahren</translation>
    </message>
    <message>
        <source>Run the velocity sweep first</source>
        <translation>Erst die Geschwindigkeitsfahrt fahren</translation>
    </message>
    <message>
        <source>Run the breakaway sweep to its end first</source>
        <translation>Erst die Losbrechfahrt zu Ende fahren</translation>
    </message>
    <message>
        <source>total at %1 %2 (%3)</source>
        <translation>gesamt bei %1 %2 (%3)</translation>
    </message>
</context>
<context>
    <name>ParameterWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Close Breakaway</source>
        <translation>Breakaway schließen</translation>
    </message>
    <message>
        <source>The motor turns. Stop it and close?</source>
        <translation>Der Motor dreht. Anhalten und schließen?</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Anhalten und schließen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
</context>
<context>
    <name>ResidualAxis</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>rotor angle</source>
        <translation>Rotorwinkel</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>motor force</source>
        <translation>Motorkraft</translation>
    </message>
    <message>
        <source>motor torque</source>
        <translation>Motormoment</translation>
    </message>
    <message>
        <source>travel since the reversal</source>
        <translation>Weg seit der Umkehr</translation>
    </message>
    <message>
        <source>angle since the reversal</source>
        <translation>Winkel seit der Umkehr</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
</context>
<context>
    <name>RunName</name>
    <message>
        <source>Moving slowly</source>
        <translation>Langsame Bewegung</translation>
    </message>
    <message>
        <source>Driven by hand</source>
        <translation>Von Hand gefahren</translation>
    </message>
    <message>
        <source>Velocity step</source>
        <translation>Geschwindigkeitssprung</translation>
    </message>
    <message>
        <source>Wiring check</source>
        <translation>Verdrahtungsprüfung</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identifikation</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Velocity sweep</source>
        <translation>Geschwindigkeitsfahrt</translation>
    </message>
    <message>
        <source>Breakaway sweep</source>
        <translation>Losbrechfahrt</translation>
    </message>
    <message>
        <source>Trial of the map</source>
        <translation>Erprobung der Karte</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Position step</source>
        <translation>Lagesprung</translation>
    </message>
</context>
<context>
    <name>RunState</name>
    <message>
        <source>needs a board</source>
        <translation>braucht ein Board</translation>
    </message>
    <message>
        <source>%1 % done</source>
        <translation>%1 % erledigt</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
</context>
<context>
    <name>RunWords</name>
    <message>
        <source>Friction map</source>
        <translation>Reibungskarte</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>nothing missing</source>
        <translation>nichts fehlt</translation>
    </message>
    <message>
        <source>named</source>
        <translation>benannt</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>mehrdeutig</translation>
    </message>
    <message>
        <source>something without a name</source>
        <translation>etwas ohne Namen</translation>
    </message>
    <message>
        <source>too little to tell</source>
        <translation>zu wenig für ein Urteil</translation>
    </message>
    <message>
        <source>static</source>
        <translation>Haft</translation>
    </message>
    <message>
        <source>Coulomb</source>
        <translation>Coulomb</translation>
    </message>
    <message>
        <source>Kt</source>
        <translation>Kt</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>being recorded</source>
        <translation>wird aufgezeichnet</translation>
    </message>
    <message>
        <source>%1 s, %2 samples</source>
        <translation>%1 s, %2 Messwerte</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>%1 bytes damaged</source>
        <translation>%1 Byte beschädigt</translation>
    </message>
    <message>
        <source>ended by: %1</source>
        <translation>beendet: %1</translation>
    </message>
</context>
<context>
    <name>SettingWords</name>
    <message>
        <source>Velocity Kp</source>
        <translation>Geschwindigkeit Kp</translation>
    </message>
    <message>
        <source>Current per velocity error: stiffer against loads, and louder.</source>
        <translation>Strom je Geschwindigkeitsfehler: steifer gegen Lasten, und lauter.</translation>
    </message>
    <message>
        <source>Velocity Ki</source>
        <translation>Geschwindigkeit Ki</translation>
    </message>
    <message>
        <source>Current per accumulated velocity error: takes away what a load leaves.</source>
        <translation>Strom je aufsummiertem Geschwindigkeitsfehler: nimmt weg, was eine Last übrig lässt.</translation>
    </message>
    <message>
        <source>Velocity Kd</source>
        <translation>Geschwindigkeit Kd</translation>
    </message>
    <message>
        <source>Current per change of the velocity error: damps, and amplifies noise.</source>
        <translation>Strom je Änderung des Geschwindigkeitsfehlers: dämpft, und verstärkt Rauschen.</translation>
    </message>
    <message>
        <source>Position Kp</source>
        <translation>Lage Kp</translation>
    </message>
    <message>
        <source>Current per position error, when a position is held.</source>
        <translation>Strom je Lagefehler, wenn eine Lage gehalten wird.</translation>
    </message>
    <message>
        <source>Position Ki</source>
        <translation>Lage Ki</translation>
    </message>
    <message>
        <source>Current per accumulated position error: takes away what friction leaves.</source>
        <translation>Strom je aufsummiertem Lagefehler: nimmt weg, was die Reibung übrig lässt.</translation>
    </message>
    <message>
        <source>Position Kd</source>
        <translation>Lage Kd</translation>
    </message>
    <message>
        <source>Current per speed of the position error: damps the approach.</source>
        <translation>Strom je Änderung des Lagefehlers: dämpft das Anfahren.</translation>
    </message>
    <message>
        <source>Observer cutoff g</source>
        <translation>Grenzfrequenz g</translation>
    </message>
    <message>
        <source>Bandwidth of the disturbance observer&apos;s feedback; 0 switches the feedback off.</source>
        <translation>Bandbreite der Rückführung des Störgrößenbeobachters; 0 schaltet sie ab.</translation>
    </message>
    <message>
        <source>Nominal inertia</source>
        <translation>Nennträgheit</translation>
    </message>
    <message>
        <source>Nominal mass</source>
        <translation>Nennmasse</translation>
    </message>
    <message>
        <source>What the observer takes for the moving parts.</source>
        <translation>Wofür der Beobachter die bewegten Teile hält.</translation>
    </message>
    <message>
        <source>Nominal torque constant</source>
        <translation>Nenn-Momentkonstante</translation>
    </message>
    <message>
        <source>Nominal force constant</source>
        <translation>Nenn-Kraftkonstante</translation>
    </message>
    <message>
        <source>What the observer takes the motor to give per ampere.</source>
        <translation>Was der Motor nach Ansicht des Beobachters je Ampere abgibt.</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>The controller asks for no more current than this, either way.</source>
        <translation>Der Regler verlangt nie mehr Strom als diesen, in keiner Richtung.</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>Grenze der Geschwindigkeit</translation>
    </message>
    <message>
        <source>The controller goes no faster than this, either way.</source>
        <translation>Der Regler fährt nie schneller als so, in keiner Richtung.</translation>
    </message>
    <message>
        <source>Speed observer w</source>
        <translation>Beobachter w</translation>
    </message>
    <message>
        <source>Bandwidth of the speed from the encoder&apos;s counts: faster lags less, and lets more of their rounding through.</source>
        <translation>Bandbreite der Geschwindigkeit aus den Inkrementen: schneller hinkt weniger nach und lässt mehr von deren Rundung durch.</translation>
    </message>
    <message>
        <source>Current loop w</source>
        <translation>Stromregelung w</translation>
    </message>
    <message>
        <source>Bandwidth of the current loop: faster follows more closely, and lets more of the sensor&apos;s noise into the winding.</source>
        <translation>Bandbreite der Stromregelung: schneller folgt enger und lässt mehr vom Rauschen des Sensors in die Wicklung.</translation>
    </message>
    <message>
        <source>A/(m s)</source>
        <translation>A/(m s)</translation>
    </message>
    <message>
        <source>A/(rad s)</source>
        <translation>A/(rad s)</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>ab %1</translation>
    </message>
</context>
<context>
    <name>breakaway::BenchProject</name>
    <message>
        <source>Nothing can be kept: %1</source>
        <translation>Nichts kann aufbewahrt werden: %1</translation>
    </message>
    <message>
        <source>Kept in the project: %1</source>
        <translation>Im Projekt: %1</translation>
    </message>
</context>
<context>
    <name>breakaway::BenchRuns</name>
    <message>
        <source>This is another board: what was measured on %1 is kept until it comes back</source>
        <translation>Das ist ein anderes Board: was an %1 gemessen wurde, bleibt aufbewahrt, bis es wiederkommt</translation>
    </message>
    <message>
        <source>The sweep goes on after %1 breakaways</source>
        <translation>Die Fahrt geht nach %1 Losbrechvorgängen weiter</translation>
    </message>
    <message>
        <source>First: %1</source>
        <translation>Zuvor: %1</translation>
    </message>
    <message>
        <source>Home first: the ends of the travel are not known yet</source>
        <translation>Erst die Referenzfahrt: die Enden des Wegs sind noch nicht bekannt</translation>
    </message>
    <message>
        <source>No board is connected</source>
        <translation>Kein Board ist verbunden</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Home first: a step needs room, and the ends are not known yet</source>
        <translation>Erst die Referenzfahrt: ein Sprung braucht Platz, und die Enden sind noch nicht bekannt</translation>
    </message>
</context>
<context>
    <name>breakaway::BoardBar</name>
    <message>
        <source>Breakaway</source>
        <translation>Breakaway</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>This board and its motor are computed; no hardware moves</source>
        <translation>Dieses Board und sein Motor sind gerechnet; keine Hardware bewegt sich</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Stop the motor</source>
        <translation>Motor anhalten</translation>
    </message>
    <message>
        <source>Stop the motor at once and open its windings. Esc and Space do the same from anywhere.</source>
        <translation>Den Motor sofort anhalten und seine Wicklungen öffnen. Esc und Leertaste tun überall dasselbe.</translation>
    </message>
    <message>
        <source>The board in detail</source>
        <translation>Das Board im Einzelnen</translation>
    </message>
    <message>
        <source>Device, firmware, link and lost samples</source>
        <translation>Gerät, Firmware, Verbindung und verlorene Messwerte</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Activity</source>
        <translation>Tätigkeit</translation>
    </message>
    <message>
        <source>Progress of what runs</source>
        <translation>Fortschritt dessen, was läuft</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Restzeit</translation>
    </message>
    <message>
        <source>When it ends</source>
        <translation>Wann es endet</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1, %2 verl.</translation>
    </message>
    <message>
        <source>No board</source>
        <translation>Kein Board</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Verlorene Messwerte</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × Echtzeit</translation>
    </message>
    <message>
        <source>choose a board on the first page</source>
        <translation>auf der ersten Seite ein Board wählen</translation>
    </message>
    <message>
        <source>STOP opens the windings</source>
        <translation>STOPP öffnet die Wicklungen</translation>
    </message>
    <message>
        <source>windings open</source>
        <translation>Wicklungen offen</translation>
    </message>
    <message>
        <source>Working it out</source>
        <translation>Wird geschätzt</translation>
    </message>
    <message>
        <source>Until STOP</source>
        <translation>Bis STOPP</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>done at %1</source>
        <translation>fertig um %1</translation>
    </message>
    <message>
        <source>tries again every second, motor off</source>
        <translation>versucht es jede Sekunde wieder, Motor aus</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
</context>
<context>
    <name>breakaway::BoardList</name>
    <message>
        <source>A servo motor of 0.07 Nm/A with an index; the one to begin with</source>
        <translation>Ein Servomotor von 0,07 Nm/A mit Index; der für den Anfang</translation>
    </message>
    <message>
        <source>A small motor with a 14:1 gear behind it, seen from the motor&apos;s shaft</source>
        <translation>Ein kleiner Motor mit einem 14:1-Getriebe dahinter, von der Motorwelle aus gesehen</translation>
    </message>
    <message>
        <source>A linear axis with a stop at each end</source>
        <translation>Eine Linearachse mit einem Anschlag an jedem Ende</translation>
    </message>
    <message>
        <source>The servo, with 40 % of its friction in one swing around the rotor</source>
        <translation>Der Servo, mit 40 % seiner Reibung in einer Schwankung um den Rotor</translation>
    </message>
    <message>
        <source>A motor of 0.134 Nm/A with very little friction, as in a published simulation</source>
        <translation>Ein Motor von 0,134 Nm/A mit sehr wenig Reibung, wie in einer veröffentlichten Simulation</translation>
    </message>
    <message>
        <source>Boards that can be connected; a double click connects</source>
        <translation>Boards, die sich verbinden lassen; ein Doppelklick verbindet</translation>
    </message>
    <message>
        <source>Boards to connect to</source>
        <translation>Boards zum Verbinden</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>On a serial port</source>
        <translation>An einer seriellen Schnittstelle</translation>
    </message>
    <message>
        <source>On the network</source>
        <translation>Im Netz</translation>
    </message>
    <message>
        <source>TCP address…</source>
        <translation>TCP-Adresse…</translation>
    </message>
    <message>
        <source>A board behind a network adapter, or breakaway-board on this machine: write its address below</source>
        <translation>Ein Board hinter einem Netzadapter, oder breakaway-board auf diesem Rechner: seine Adresse unten eintragen</translation>
    </message>
    <message>
        <source>nothing is plugged in</source>
        <translation>nichts ist angesteckt</translation>
    </message>
    <message>
        <source>Plug the board in; its port appears here by itself. A cable that only charges carries no data</source>
        <translation>Das Board anstecken; seine Schnittstelle erscheint hier von selbst. Ein reines Ladekabel überträgt keine Daten</translation>
    </message>
    <message>
        <source>to begin with</source>
        <translation>für den Anfang</translation>
    </message>
    <message>
        <source>14:1 gear</source>
        <translation>Getriebe 14:1</translation>
    </message>
    <message>
        <source>axis between stops</source>
        <translation>Achse mit Anschlägen</translation>
    </message>
    <message>
        <source>friction in one swing</source>
        <translation>Reibung schwankt</translation>
    </message>
    <message>
        <source>little friction</source>
        <translation>wenig Reibung</translation>
    </message>
</context>
<context>
    <name>breakaway::BodePlot</name>
    <message>
        <source>Gain and phase of the open loop over frequency</source>
        <translation>Betrag und Phase des offenen Kreises über der Frequenz</translation>
    </message>
    <message>
        <source>Gain of the open loop (dB)</source>
        <translation>Betrag des offenen Kreises (dB)</translation>
    </message>
    <message>
        <source>Its phase (°) over rad/s</source>
        <translation>Seine Phase (°) über rad/s</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
</context>
<context>
    <name>breakaway::ComparePage</name>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Diagnose</source>
        <translation>Diagnose starten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Prüfstand</translation>
    </message>
    <message>
        <source>What is believed of the rig: NAME.bench.json. Dropping the file here does the same.</source>
        <translation>Was vom Aufbau angenommen wird: NAME.bench.json. Die Datei hier abzulegen bewirkt dasselbe.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichn.</translation>
    </message>
    <message>
        <source>NAME.csv, or another tool&apos;s log, which is shown as it is understood before it is opened. Dropping the file here does the same.</source>
        <translation>NAME.csv, oder das Protokoll eines anderen Programms; wie es verstanden wird, ist vor dem Öffnen zu sehen. Die Datei hier abzulegen bewirkt dasselbe.</translation>
    </message>
    <message>
        <source>Held-out</source>
        <translation>Prüfdaten</translation>
    </message>
    <message>
        <source>A second recording to prove the findings on; without it, parts of the first are held out</source>
        <translation>Eine zweite Aufzeichnung, an der sich die Befunde beweisen; ohne sie werden Teile der ersten zurückgehalten</translation>
    </message>
    <message>
        <source>Last recording</source>
        <translation>Letzte Aufzeichnung</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>Sealed trial</source>
        <translation>Versiegelter Versuch</translation>
    </message>
    <message>
        <source>Open a bench</source>
        <translation>Prüfstandsdatei öffnen</translation>
    </message>
    <message>
        <source>Bench (*.bench.json *.json)</source>
        <translation>Prüfstand (*.bench.json *.json)</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings and logs (*)</source>
        <translation>Aufzeichnungen und Protokolle (*)</translation>
    </message>
    <message>
        <source>Open a held-out recording</source>
        <translation>Zurückgehaltene Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Base parameters</source>
        <translation>Grundparameter</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Run the next experiment</source>
        <translation>Nächsten Versuch fahren</translation>
    </message>
    <message>
        <source>Open a recording first</source>
        <translation>Erst eine Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>All of it is visible: zoom in with the wheel, over the measurement</source>
        <translation>Alles ist sichtbar: mit dem Mausrad über der Messung hineinzoomen</translation>
    </message>
    <message>
        <source>%1, %2 s to %3 s</source>
        <translation>%1, %2 s bis %3 s</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>drehend</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2 more</source>
        <translation>%1, %2 weitere</translation>
    </message>
    <message>
        <source>parts of the recording</source>
        <translation>Teile der Aufzeichnung</translation>
    </message>
    <message>
        <source>Take the last recording that was made in the live plots</source>
        <translation>Die letzte Aufzeichnung nehmen, die in den Live-Kurven gemacht wurde</translation>
    </message>
    <message>
        <source>Nothing was recorded yet: Record, below the page, begins one</source>
        <translation>Noch wurde nichts aufgezeichnet: Aufzeichnen, unter der Seite, beginnt damit</translation>
    </message>
    <message>
        <source>A recording of a simulated rig with concealed physics</source>
        <translation>Eine Aufzeichnung eines simulierten Aufbaus mit verborgener Physik</translation>
    </message>
    <message>
        <source>The examples are not installed</source>
        <translation>Die Beispiele sind nicht installiert</translation>
    </message>
    <message>
        <source>Conceals physics in a simulated rig and records it; whoever diagnoses sees bench and recordings alone. Unseal says whether the answer is right.</source>
        <translation>Verbirgt Physik in einem simulierten Aufbau und zeichnet ihn auf; wer diagnostiziert, sieht nur Prüfstandsdatei und Aufzeichnungen. Entsiegeln sagt, ob die Antwort stimmt.</translation>
    </message>
    <message>
        <source>Fits the declared physics, searches for what is missing, and decides on data that was held out</source>
        <translation>Passt die angegebene Physik an, sucht nach dem, was fehlt, und entscheidet an zurückgehaltenen Daten</translation>
    </message>
    <message>
        <source>End the diagnosis</source>
        <translation>Die Diagnose beenden</translation>
    </message>
    <message>
        <source>No diagnosis is running</source>
        <translation>Keine Diagnose läuft</translation>
    </message>
    <message>
        <source>%1 % done</source>
        <translation>%1 % erledigt</translation>
    </message>
    <message>
        <source>nothing missing</source>
        <translation>nichts fehlt</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>1 Befund</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>%1 Befunde</translation>
    </message>
    <message>
        <source>not diagnosed yet</source>
        <translation>ohne Diagnose</translation>
    </message>
    <message>
        <source>needs a recording</source>
        <translation>Aufzeichnung fehlt</translation>
    </message>
    <message>
        <source>Held as declared</source>
        <translation>Festgehalten wie angegeben</translation>
    </message>
    <message>
        <source>%1 %2 with 95 % confidence</source>
        <translation>%1 %2 mit 95 % Sicherheit</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 mNm</source>
        <translation>%1 mNm</translation>
    </message>
    <message>
        <source>Wander of the friction</source>
        <translation>Schwanken der Reibung</translation>
    </message>
    <message>
        <source>%1 % of it</source>
        <translation>%1 % davon</translation>
    </message>
    <message>
        <source>Torque that changes at random and has no place: %1 rms, over about %2 s</source>
        <translation>Drehmoment, das sich zufällig ändert und keinen Ort hat: %1 effektiv, über etwa %2 s</translation>
    </message>
    <message>
        <source>Not fitted yet</source>
        <translation>Noch nicht angepasst</translation>
    </message>
    <message>
        <source>Untick one to see the fit without it</source>
        <translation>Abwählen zeigt die Anpassung ohne ihn</translation>
    </message>
    <message>
        <source>This motion can&apos;t be foreseen (%1 off): the torque counts</source>
        <translation>Diese Bewegung ist nicht vorhersehbar (%1 daneben): es zählt das Drehmoment</translation>
    </message>
    <message>
        <source>As ticked, the error is %1</source>
        <translation>Wie angekreuzt ist der Fehler %1</translation>
    </message>
    <message>
        <source>Point at a plot to read it</source>
        <translation>Zum Ablesen auf eine Kurve zeigen</translation>
    </message>
    <message>
        <source>Which physics a bench file leaves out, and the proof.</source>
        <translation>Was eine Prüfstandsdatei auslässt, mit Beweis.</translation>
    </message>
    <message>
        <source>Open the log as a recording first, or leave it</source>
        <translation>Erst das Log als Aufzeichnung öffnen, oder lassen</translation>
    </message>
    <message>
        <source>Check what each column is taken as; then open the log as a recording</source>
        <translation>Prüfen, als was jede Spalte gilt; dann das Log als Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Open a bench file and a recording on the left, or the example</source>
        <translation>Links eine Prüfstandsdatei und eine Aufzeichnung öffnen, oder das Beispiel</translation>
    </message>
    <message>
        <source>The diagnosis runs; Finish now takes what was found so far, Cancel ends it</source>
        <translation>Die Diagnose läuft; „Abschließen“ nimmt, was bisher gefunden ist, „Abbrechen“ beendet sie</translation>
    </message>
    <message>
        <source>It looks no further; what was found is being proved</source>
        <translation>Es sucht nicht weiter; was gefunden ist, wird bewiesen</translation>
    </message>
    <message>
        <source>Finish now</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>Weigh and prove what was found so far, and look no further</source>
        <translation>Was bisher gefunden ist, abwägen und beweisen, und nicht weiter suchen</translation>
    </message>
    <message>
        <source>Diagnose finds what the bench file leaves out</source>
        <translation>Die Diagnose findet, was die Prüfstandsdatei auslässt</translation>
    </message>
    <message>
        <source>Beneath</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Takes away what lies beneath</source>
        <translation>Nimmt weg, was darunter liegt</translation>
    </message>
    <message>
        <source>Take away what lies beneath</source>
        <translation>Wegnehmen, was darunter liegt</translation>
    </message>
    <message>
        <source>Lay a recording beneath</source>
        <translation>Eine Aufnahme darunter legen</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.blocks)</source>
        <translation>Aufnahmen (*.csv *.blocks)</translation>
    </message>
    <message>
        <source>No recording lies beneath</source>
        <translation>Keine Aufnahme liegt darunter</translation>
    </message>
    <message>
        <source>Another recording that is drawn dashed beneath this one, from where both begin to move; Runs lays a kept one there</source>
        <translation>Eine andere Aufnahme, die gestrichelt unter dieser liegt, von da an, wo beide sich zu bewegen beginnen; Läufe legt eine aufbewahrte dorthin</translation>
    </message>
</context>
<context>
    <name>breakaway::ComparedPlots</name>
    <message>
        <source>Evidence</source>
        <translation>Beleg</translation>
    </message>
    <message>
        <source>Motion and residual</source>
        <translation>Bewegung und Residuum</translation>
    </message>
    <message>
        <source>Measured and simulated motion, and what is left between them</source>
        <translation>Gemessene und simulierte Bewegung, und was zwischen ihnen bleibt</translation>
    </message>
    <message>
        <source>Axis of the residual</source>
        <translation>Achse des Residuums</translation>
    </message>
    <message>
        <source>Over what the residual is drawn. Drag and wheel zoom in time.</source>
        <translation>Worüber das Residuum gezeichnet wird. Ziehen und Mausrad zoomen in der Zeit.</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>motor torque or force</source>
        <translation>Motormoment oder Motorkraft</translation>
    </message>
    <message>
        <source>travel since reversal</source>
        <translation>Weg seit der Umkehr</translation>
    </message>
    <message>
        <source>Residual over %1</source>
        <translation>Residuum über %1</translation>
    </message>
    <message>
        <source>Keep visible part</source>
        <translation>Ausschnitt behalten</translation>
    </message>
    <message>
        <source>Puts what the plot over time shows into the project, as a recording of its own</source>
        <translation>Legt den sichtbaren Zeitabschnitt als eigene Aufzeichnung ins Projekt</translation>
    </message>
    <message>
        <source>What is left over the finding&apos;s own axis, before and after</source>
        <translation>Was über der eigenen Achse des Befunds bleibt, vorher und nachher</translation>
    </message>
    <message>
        <source>Comes with the diagnosis: press Diagnose</source>
        <translation>Kommt mit „Diagnose starten“</translation>
    </message>
    <message>
        <source>The evidence lies over its finding&apos;s own axis; Motion and residual is drawn over any</source>
        <translation>Der Beleg liegt über der Achse seines Befunds; Bewegung und Rest gibt es über jeder</translation>
    </message>
</context>
<context>
    <name>breakaway::Comparison</name>
    <message>
        <source>%1: %2 rows</source>
        <translation>%1: %2 Zeilen</translation>
    </message>
    <message>
        <source>A diagnosis is running</source>
        <translation>Eine Diagnose läuft</translation>
    </message>
    <message>
        <source>Open a bench and a recording first</source>
        <translation>Erst eine Prüfstandsdatei und eine Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Open the recording&apos;s bench first</source>
        <translation>Erst die Prüfstandsdatei der Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Open a recording first</source>
        <translation>Erst eine Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>beginnt</translation>
    </message>
    <message>
        <source>%1 lies beside the recording and was opened with it</source>
        <translation>%1 liegt neben der Aufzeichnung und wurde mit ihr geöffnet</translation>
    </message>
    <message>
        <source>%1 holds no position to lay beneath</source>
        <translation>%1 enthält keine Position, die darunter gelegt werden könnte</translation>
    </message>
</context>
<context>
    <name>breakaway::ConnectPage</name>
    <message>
        <source>Homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Identification and sweeps</source>
        <translation>Identifikation und Messfahrten</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Friction compensation</source>
        <translation>Reibungskompensation</translation>
    </message>
    <message>
        <source>Not possible with this board:</source>
        <translation>Mit diesem Board nicht möglich:</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Choose a board and connect. Nothing moves, and nothing is written to it.</source>
        <translation>Ein Board wählen und verbinden. Nichts bewegt sich, nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Boards</translation>
    </message>
    <message>
        <source>Address of the board</source>
        <translation>Adresse des Boards</translation>
    </message>
    <message>
        <source>serial:PORT@BAUD or tcp:HOST:PORT. A VESC doesn&apos;t know its motor&apos;s pole pairs and encoder counts: write ?pole_pairs=7&amp;counts_per_rev=16384 behind its address</source>
        <translation>serial:PORT@BAUD oder tcp:HOST:PORT. Ein VESC kennt weder Polpaare noch Encoder-Inkremente seines Motors: ?pole_pairs=7&amp;counts_per_rev=16384 hinter seine Adresse schreiben</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Open rig file…</source>
        <translation>Aufbaudatei öffnen…</translation>
    </message>
    <message>
        <source>Add a simulated rig of your own, NAME.rig.json</source>
        <translation>Einen eigenen simulierten Aufbau hinzufügen, NAME.rig.json</translation>
    </message>
    <message>
        <source>Connected board</source>
        <translation>Verbundenes Board</translation>
    </message>
    <message>
        <source>Turn slowly</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Pace of simulated time</source>
        <translation>Tempo der simulierten Zeit</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × Echtzeit</translation>
    </message>
    <message>
        <source>Open a simulated rig</source>
        <translation>Simulierten Aufbau öffnen</translation>
    </message>
    <message>
        <source>Rig file (*.rig.json)</source>
        <translation>Aufbaudatei (*.rig.json)</translation>
    </message>
    <message>
        <source>Connect to this address; the motor stays off</source>
        <translation>Mit dieser Adresse verbinden; der Motor bleibt aus</translation>
    </message>
    <message>
        <source>No board is chosen in the list, and no address is given</source>
        <translation>In der Liste ist kein Board gewählt, und keine Adresse ist angegeben</translation>
    </message>
    <message>
        <source>How fast time passes on the simulated board: at 20 × real time a sweep of 20 minutes takes one</source>
        <translation>Wie schnell die Zeit auf dem simulierten Board vergeht: bei 20 × Echtzeit dauert eine Fahrt von 20 Minuten eine</translation>
    </message>
    <message>
        <source>A real board keeps its own time</source>
        <translation>Ein echtes Board hat seine eigene Zeit</translation>
    </message>
    <message>
        <source>No board is connected</source>
        <translation>Kein Board ist verbunden</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Aufgeben</translation>
    </message>
    <message>
        <source>Don&apos;t try to connect any more</source>
        <translation>Keine Verbindung mehr versuchen</translation>
    </message>
    <message>
        <source>Stop the motor and let the board go</source>
        <translation>Den Motor anhalten und das Board freigeben</translation>
    </message>
    <message>
        <source>Connecting to %1 …</source>
        <translation>Verbindet mit %1 …</translation>
    </message>
    <message>
        <source>Not connected: %1</source>
        <translation>Nicht verbunden: %1</translation>
    </message>
    <message>
        <source>Link lost: %1. Trying again every second; the motor stays off when the board comes back.</source>
        <translation>Verbindung verloren: %1. Jede Sekunde ein neuer Versuch; der Motor bleibt aus, wenn das Board wiederkommt.</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>link lost, trying again</source>
        <translation>weg, versucht es wieder</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>no board</source>
        <translation>kein Board</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Regeltakt</translation>
    </message>
    <message>
        <source>Asked for values</source>
        <translation>Messwerte abgefragt</translation>
    </message>
    <message>
        <source>The board sends one sample for each tick of its loop</source>
        <translation>Das Board sendet je Takt seiner Regelung einen Messwert</translation>
    </message>
    <message>
        <source>As often as the board can answer while half of its time stays free</source>
        <translation>So oft das Board antworten kann, während die Hälfte seiner Zeit frei bleibt</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>%1 counts per m</source>
        <translation>%1 Inkremente je m</translation>
    </message>
    <message>
        <source>%1 counts per turn</source>
        <translation>%1 Inkremente je Umdrehung</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>once over the travel</source>
        <translation>einmal über den Weg</translation>
    </message>
    <message>
        <source>once per turn</source>
        <translation>einmal je Umdrehung</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Speisung</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>Go to and fro</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Go to and fro slowly over half the travel, until STOP</source>
        <translation>Langsam über den halben Weg hin und her fahren, bis STOPP</translation>
    </message>
    <message>
        <source>Turn to and fro slowly, ±6 rad/s, until STOP</source>
        <translation>Langsam hin und her drehen, ±6 rad/s, bis STOPP</translation>
    </message>
    <message>
        <source>Connect anew</source>
        <translation>Neu verbinden</translation>
    </message>
    <message>
        <source>A simulated board: every page works as with a real one, and nothing can break.</source>
        <translation>Ein simuliertes Board: jede Seite arbeitet wie mit einem echten, und nichts kann kaputtgehen.</translation>
    </message>
    <message>
        <source>Connected. Next: %1; or %2, which makes by itself what it needs.</source>
        <translation>Verbunden. Weiter mit %1; oder gleich mit %2, die selbst macht, was sie braucht.</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>State of the connection</source>
        <translation>Stand der Verbindung</translation>
    </message>
    <message>
        <source>What came of connecting, and what is next</source>
        <translation>Was aus dem Verbinden wurde, und was als Nächstes kommt</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Motor identifizieren</translation>
    </message>
    <message>
        <source>Go on to Drive by hand</source>
        <translation>Weiter: Von Hand fahren</translation>
    </message>
    <message>
        <source>Go on to Identify</source>
        <translation>Weiter: Identifizieren</translation>
    </message>
    <message>
        <source>The next step; nothing moves before it is asked to</source>
        <translation>Der nächste Schritt; nichts bewegt sich, bevor es verlangt wird</translation>
    </message>
</context>
<context>
    <name>breakaway::Connection</name>
    <message>
        <source>Connected to %1</source>
        <translation>Verbunden mit %1</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>link lost, connecting again</source>
        <translation>Verbindung verloren, verbindet wieder</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>powered</source>
        <translation>bestromt</translation>
    </message>
    <message>
        <source>idle, windings open</source>
        <translation>in Ruhe, Wicklungen offen</translation>
    </message>
    <message>
        <source>No board is connected</source>
        <translation>Kein Board ist verbunden</translation>
    </message>
    <message>
        <source>Busy: %1. STOP ends it.</source>
        <translation>Beschäftigt: %1. STOPP beendet es.</translation>
    </message>
    <message>
        <source>stopped by the board</source>
        <translation>vom Board angehalten</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>STOP: the motor is off</source>
        <translation>STOPP: der Motor ist aus</translation>
    </message>
    <message>
        <source>stopped by watchdog</source>
        <translation>vom Wächter angehalten</translation>
    </message>
    <message>
        <source>The window did not answer for %1 ms, so the motor was stopped</source>
        <translation>Das Fenster hat %1 ms nicht geantwortet, darum wurde der Motor angehalten</translation>
    </message>
    <message>
        <source>%1. What ran had come to %2 %, and what it measured is kept</source>
        <translation>%1. Was lief, war bei %2 %, und was es gemessen hat, bleibt erhalten</translation>
    </message>
    <message>
        <source>The machine was too busy: for %1 ms the window got hardly any processor time, so the motor was stopped; end what else runs, or wait for it</source>
        <translation>Der Rechner war überlastet: Das Fenster bekam %1 ms lang kaum Rechenzeit, darum wurde der Motor angehalten; beenden Sie, was sonst läuft, oder warten Sie darauf</translation>
    </message>
</context>
<context>
    <name>breakaway::EvidencePlot</name>
    <message>
        <source>Residual torque over the finding&apos;s axis, before and after</source>
        <translation>Restmoment über der Achse des Befunds, vorher und nachher</translation>
    </message>
    <message>
        <source>No place stands out on unseen data</source>
        <translation>Auf ungesehenen Daten sticht kein Ort heraus</translation>
    </message>
    <message>
        <source>The residual torque over the finding&apos;s own axis comes with the diagnosis</source>
        <translation>Das Restmoment über der Achse des Befunds kommt mit der Diagnose</translation>
    </message>
    <message>
        <source>What unseen data show is being worked out</source>
        <translation>Was ungesehene Daten zeigen, wird gerade berechnet</translation>
    </message>
    <message>
        <source>too little data</source>
        <translation>zu wenig Daten</translation>
    </message>
    <message>
        <source>%1 %2    before %3    after %4</source>
        <translation>%1 %2    vorher %3    nachher %4</translation>
    </message>
    <message>
        <source>base model</source>
        <translation>Grundmodell</translation>
    </message>
    <message>
        <source>with findings</source>
        <translation>mit Befunden</translation>
    </message>
    <message>
        <source>Residual force (N) over %1, unseen, bands 95 %</source>
        <translation>Rest (N) über %1, Bänder 95 %</translation>
    </message>
    <message>
        <source>Residual torque (mNm) over %1, unseen, bands 95 %</source>
        <translation>Rest (mNm) über %1, Bänder 95 %</translation>
    </message>
    <message>
        <source>— its law</source>
        <translation>— Gesetz</translation>
    </message>
</context>
<context>
    <name>breakaway::ExperimentRun</name>
    <message>
        <source>Moves the axis for %1 s within the board&apos;s limits, records it, and opens the recording here.</source>
        <translation>Bewegt die Achse %1 s lang innerhalb der Grenzen des Boards, zeichnet das auf und öffnet die Aufzeichnung hier.</translation>
    </message>
    <message>
        <source>Diagnose first: the experiment comes with the answer</source>
        <translation>Erst diagnostizieren: der Versuch kommt mit der Antwort</translation>
    </message>
    <message>
        <source>No experiment is called for</source>
        <translation>Kein Versuch ist nötig</translation>
    </message>
    <message>
        <source>This experiment takes hands: a board alone can&apos;t make it</source>
        <translation>Dieser Versuch braucht Hände: ein Board allein kann ihn nicht fahren</translation>
    </message>
    <message>
        <source>Connect the board of this rig first</source>
        <translation>Erst das Board dieses Aufbaus verbinden</translation>
    </message>
    <message>
        <source>The board has another kind of axis</source>
        <translation>Das Board hat eine andere Art von Achse</translation>
    </message>
    <message>
        <source>A recording is running</source>
        <translation>Eine Aufzeichnung läuft</translation>
    </message>
    <message>
        <source>The experiment is recorded and open: Diagnose says what it shows</source>
        <translation>Der Versuch ist aufgezeichnet und offen: die Diagnose sagt, was er zeigt</translation>
    </message>
</context>
<context>
    <name>breakaway::FileSlot</name>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1: keine</translation>
    </message>
</context>
<context>
    <name>breakaway::FindingsList</name>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>What is missing, the most important first; untick one to see the fit without it</source>
        <translation>Was fehlt, das Wichtigste zuerst; einen abwählen, um die Anpassung ohne ihn zu sehen</translation>
    </message>
    <message>
        <source>No effect of the catalogue is missing.</source>
        <translation>Kein Effekt des Katalogs fehlt.</translation>
    </message>
    <message>
        <source>Next experiment</source>
        <translation>Nächster Versuch</translation>
    </message>
    <message>
        <source>Diagnose says where the recording departs from what its bench file declares, which physics was left out, how big it is, and how much better the simulation gets on data that was held out.</source>
        <translation>Die Diagnose sagt, wo die Aufzeichnung von dem abweicht, was ihre Prüfstandsdatei angibt, welche Physik ausgelassen wurde, wie groß sie ist, und wie viel besser die Simulation auf zurückgehaltenen Daten wird.</translation>
    </message>
    <message>
        <source>Untick to see the fit without it (Return)</source>
        <translation>Abwählen, um die Anpassung ohne ihn zu sehen (Eingabetaste)</translation>
    </message>
    <message>
        <source>%1 % of what the base model leaves; chance would do so in %2 % of cases</source>
        <translation>%1 % dessen, was das Grundmodell übrig lässt; der Zufall täte das in %2 % der Fälle</translation>
    </message>
    <message>
        <source>Could also be: %1.</source>
        <translation>Könnte auch sein: %1.</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Its evidence</source>
        <translation>Der Beleg dafür</translation>
    </message>
    <message>
        <source>The residual over this finding&apos;s own axis, before and after</source>
        <translation>Der Rest über der eigenen Achse dieses Befundes, vorher und nachher</translation>
    </message>
    <message>
        <source>Error on unseen data with others in its place, lines 95 %</source>
        <translation>Fehler auf ungesehenen Daten mit anderen an seiner Stelle, Striche 95 %</translation>
    </message>
</context>
<context>
    <name>breakaway::FrictionPage</name>
    <message>
        <source>How alike the breakaways of one turn and the next are</source>
        <translation>Wie sehr die Losbrechmomente einer Umdrehung denen der nächsten gleichen</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Run breakaway sweep</source>
        <translation>Losbrechfahrt starten</translation>
    </message>
    <message>
        <source>Run velocity sweep</source>
        <translation>Geschw.-Fahrt</translation>
    </message>
    <message>
        <source>Averages</source>
        <translation>Mittelwerte</translation>
    </message>
    <message>
        <source>Export and use</source>
        <translation>Ausgeben und verwenden</translation>
    </message>
    <message>
        <source>Tune and try the map</source>
        <translation>Einstellen, Karte erproben</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>Messfahrten</translation>
    </message>
    <message>
        <source>Angles per turn</source>
        <translation>Winkel je Umdr.</translation>
    </message>
    <message>
        <source>Turns each way</source>
        <translation>Umdr. je Richtung</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Höchstgeschw.</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>erreichbare</translation>
    </message>
    <message>
        <source>Number of speeds</source>
        <translation>Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Time at each speed</source>
        <translation>Zeit je Geschw.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How often each angle is visited each way; what differs between turns is the doubt of the map</source>
        <translation>Wie oft jeder Winkel in jeder Richtung angefahren wird; was sich zwischen Umdrehungen unterscheidet, ist die Unsicherheit der Karte</translation>
    </message>
    <message>
        <source>How many speeds the velocity sweep measures each way</source>
        <translation>Wie viele Geschwindigkeiten die Geschwindigkeitsfahrt je Richtung misst</translation>
    </message>
    <message>
        <source>Start anew</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>A map of the project. A sweep measures today&apos;s, which is shown then.</source>
        <translation>Eine Karte des Projekts. Eine Fahrt misst die heutige, die dann gezeigt wird.</translation>
    </message>
    <message>
        <source>Friction over the travel</source>
        <translation>Reibung über dem Weg</translation>
    </message>
    <message>
        <source>Friction around the rotor</source>
        <translation>Reibung rund um den Rotor</translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation> rad/s</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Speeds lie between %1 % of it and it, in equal ratios, each both ways</source>
        <translation>Die Geschwindigkeiten liegen zwischen %1 % davon und ihr, in gleichen Verhältnissen, jede in beiden Richtungen</translation>
    </message>
    <message>
        <source>At least this long at each speed, and then on to the end of the %1</source>
        <translation>Mindestens so lange je Geschwindigkeit, und dann weiter bis zum Ende: %1</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Umdrehung</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>Hub</translation>
    </message>
    <message>
        <source>Places over travel</source>
        <translation>Orte über dem Weg</translation>
    </message>
    <message>
        <source>Breakaways per turn, evenly spaced</source>
        <translation>Losbrechvorgänge je Umdrehung, gleichmäßig verteilt</translation>
    </message>
    <message>
        <source>Places over the travel, evenly spaced; strokes are taken apart into as many</source>
        <translation>Orte über dem Weg, gleichmäßig verteilt; Hübe werden in ebenso viele zerlegt</translation>
    </message>
    <message>
        <source>Passes each way</source>
        <translation>Durchg. je Richtung</translation>
    </message>
    <message>
        <source>Strokes to and fro over the travel at several speeds.</source>
        <translation>Hübe hin und her über den Weg bei mehreren Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Turns at constant speeds, both ways, over whole turns.</source>
        <translation>Dreht mit konstanten Geschwindigkeiten in beiden Richtungen, über ganze Umdrehungen.</translation>
    </message>
    <message>
        <source>Steps over the travel; at each place the current rises slowly until the axis moves.</source>
        <translation>Geht schrittweise über den Weg; an jedem Ort steigt der Strom langsam, bis sich die Achse bewegt.</translation>
    </message>
    <message>
        <source>Steps around the rotor; at each angle the current rises slowly until the shaft moves.</source>
        <translation>Geht schrittweise um den Rotor; in jedem Winkel steigt der Strom langsam, bis sich die Welle bewegt.</translation>
    </message>
    <message>
        <source>Tunes the controller for the motor as it is known now, leaves it so, and goes slowly to and fro without and with the measured friction compensated.</source>
        <translation>Stellt den Regler für den Motor ein, wie er jetzt bekannt ist, lässt ihn so, und fährt langsam hin und her, ohne und mit Kompensation der gemessenen Reibung.</translation>
    </message>
    <message>
        <source>Forgets what the interrupted sweeps have measured; the motor stays known.</source>
        <translation>Vergisst, was die unterbrochenen Fahrten gemessen haben; der Motor bleibt bekannt.</translation>
    </message>
    <message>
        <source>No sweep is unfinished</source>
        <translation>Keine Fahrt ist unvollendet</translation>
    </message>
    <message>
        <source>map complete</source>
        <translation>Karte vollständig</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Coulomb</source>
        <translation>Coulomb</translation>
    </message>
    <message>
        <source>Mean of both ways at zero speed, 95 % interval</source>
        <translation>Mittel beider Richtungen bei Geschwindigkeit null, 95-%-Intervall</translation>
    </message>
    <message>
        <source>Viscous</source>
        <translation>Viskos</translation>
    </message>
    <message>
        <source>Slope with speed, 95 % interval</source>
        <translation>Anstieg mit der Geschwindigkeit, 95-%-Intervall</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Static, %1</source>
        <translation>Haft, %1</translation>
    </message>
    <message>
        <source>Passes correlate</source>
        <translation>Durchg. korrelieren</translation>
    </message>
    <message>
        <source>Turns correlate</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>%1 %2, %3 %4</source>
        <translation>%1 %2, %3 %4</translation>
    </message>
    <message>
        <source>They differ by %1 (%2) and %3 %4 rms (%5)</source>
        <translation>Sie unterscheiden sich um %1 (%2) und %3 %4 effektiv (%5)</translation>
    </message>
    <message>
        <source>Velocity error</source>
        <translation>Geschw.-Fehler</translation>
    </message>
    <message>
        <source>%1, with the map %2</source>
        <translation>%1, mit der Karte %2</translation>
    </message>
    <message>
        <source>rms, going slowly to and fro, tuned for use</source>
        <translation>effektiv, langsam hin und her, eingestellt zum Gebrauch</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>The force that breaks the axis away at every place, and what keeps it moving.</source>
        <translation>Was die Achse an jedem Ort losbricht, und was sie in Bewegung hält.</translation>
    </message>
    <message>
        <source>The torque that breaks the rotor away at every angle, and what keeps it moving.</source>
        <translation>Was den Rotor bei jedem Winkel losbricht, und was ihn in Bewegung hält.</translation>
    </message>
    <message>
        <source>A sweep is unfinished: Continue goes on with it, Start anew forgets it</source>
        <translation>Eine Fahrt ist unvollendet: Fortsetzen führt sie weiter, Neu beginnen vergisst sie</translation>
    </message>
    <message>
        <source>Goes on with the sweep: %1 of %2 are measured.</source>
        <translation>Führt die Fahrt weiter: %1 von %2 sind gemessen.</translation>
    </message>
    <message>
        <source>The sweep began with other settings; Run breakaway sweep begins anew with these</source>
        <translation>Die Fahrt begann mit anderen Einstellungen; Losbrechfahrt beginnt mit diesen neu</translation>
    </message>
    <message>
        <source>Mean of all bins, which share their errors; 95 % interval</source>
        <translation>Mittel aller Winkel, die ihre Fehler gemeinsam haben; 95-%-Intervall</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>breakaway::HandPage</name>
    <message>
        <source>Drive by hand</source>
        <translation>Von Hand fahren</translation>
    </message>
    <message>
        <source>The motor runs while a button is held, and its windings open when it is let go.</source>
        <translation>Der Motor läuft, solange eine Taste gehalten wird; seine Wicklungen öffnen sich, wenn sie losgelassen wird.</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Was gehalten wird</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschw.</translation>
    </message>
    <message>
        <source>Hold this at the value below</source>
        <translation>Dies auf dem Wert darunter halten</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>What is held, either way</source>
        <translation>Was gehalten wird, in jeder Richtung</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Höchstgeschw.</translation>
    </message>
    <message>
        <source>Faster than this, the motor is let go</source>
        <translation>Ist er schneller als das, wird der Motor losgelassen</translation>
    </message>
    <message>
        <source>Highest current</source>
        <translation>Höchster Strom</translation>
    </message>
    <message>
        <source>The current is held within this</source>
        <translation>Der Strom wird innerhalb davon gehalten</translation>
    </message>
    <message>
        <source> A</source>
        <translation> A</translation>
    </message>
    <message>
        <source>One step</source>
        <translation>Ein Schritt</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>How far one press of a step button goes</source>
        <translation>Wie weit ein Druck auf eine Schritttaste fährt</translation>
    </message>
    <message>
        <source>Speed of a step</source>
        <translation>Tempo des Schritts</translation>
    </message>
    <message>
        <source>How fast it goes there</source>
        <translation>Wie schnell er dorthin fährt</translation>
    </message>
    <message>
        <source> V</source>
        <translation> V</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> mm/s</translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation> rad/s</translation>
    </message>
    <message>
        <source>◀  hold: %1</source>
        <translation>◀  halten: %1</translation>
    </message>
    <message>
        <source>hold: %1  ▶</source>
        <translation>halten: %1  ▶</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>◀  %1</source>
        <translation>◀  %1</translation>
    </message>
    <message>
        <source>%1  ▶</source>
        <translation>%1  ▶</translation>
    </message>
    <message>
        <source>One step %1</source>
        <translation>Ein Schritt %1</translation>
    </message>
    <message>
        <source>Runs while it is held; the arrow keys do the same</source>
        <translation>Läuft, solange sie gehalten wird; die Pfeiltasten tun dasselbe</translation>
    </message>
    <message>
        <source>Goes one step and stops; Shift with an arrow key does the same</source>
        <translation>Fährt einen Schritt und hält an; Umschalt mit einer Pfeiltaste tut dasselbe</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>runs while held</source>
        <translation>läuft, solange gehalten</translation>
    </message>
    <message>
        <source>not now</source>
        <translation>jetzt nicht</translation>
    </message>
    <message>
        <source>Hold a button, or an arrow key after a click on the page</source>
        <translation>Eine Taste halten, oder eine Pfeiltaste nach einem Klick auf die Seite</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
</context>
<context>
    <name>breakaway::HarmonicsPlot</name>
    <message>
        <source>Orders of the turn</source>
        <translation>Ordnungen der Umdrehung</translation>
    </message>
    <message>
        <source>order of the turn</source>
        <translation>Ordnung der Umdrehung</translation>
    </message>
</context>
<context>
    <name>breakaway::HomePage</name>
    <message>
        <source>Home</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>What will move</source>
        <translation>Was sich bewegt</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>The axis feels for both ends at 50 mm/s, with a current limit that grows only until it moves.</source>
        <translation>Die Achse tastet mit 50 mm/s nach beiden Enden, mit einer Stromgrenze, die nur wächst, bis sie sich bewegt.</translation>
    </message>
    <message>
        <source>The motor is identified: half a minute standing in the middle, then strokes to and fro by voltage.</source>
        <translation>Der Motor wird identifiziert: eine halbe Minute stehend in der Mitte, dann Hübe hin und her mit Spannung.</translation>
    </message>
    <message>
        <source>It has no index: positions are counted from the lower end.</source>
        <translation>Sie hat keinen Index: Lagen zählen vom unteren Ende an.</translation>
    </message>
    <message>
        <source>From there on everything keeps 3 % of the travel, at least 2.4 mm, away from the ends.</source>
        <translation>Von da an hält alles 3 % des Wegs, mindestens 2.4 mm, Abstand von den Enden.</translation>
    </message>
    <message>
        <source>Feel for the ends, home to the index</source>
        <translation>Enden ertasten, Index anfahren</translation>
    </message>
    <message>
        <source>Home to the index</source>
        <translation>Referenzfahrt zum Index</translation>
    </message>
    <message>
        <source>Every angle of the map is counted from the encoder&apos;s index.</source>
        <translation>Jeder Winkel der Karte zählt vom Index des Encoders an.</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>not felt yet</source>
        <translation>noch nicht ertastet</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>not homed yet</source>
        <translation>noch nicht angefahren</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>From end to end</source>
        <translation>Von Ende zu Ende</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Kept away from either end</source>
        <translation>Abstand, der von beiden Enden gehalten wird</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>Unteres Ende</translation>
    </message>
    <message>
        <source>%1 mm in the board&apos;s position</source>
        <translation>%1 mm (Board)</translation>
    </message>
    <message>
        <source>Mean over the passes</source>
        <translation>Mittel der Überfahrten</translation>
    </message>
    <message>
        <source>Positions are counted from here</source>
        <translation>Lagen zählen von hier an</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervall</translation>
    </message>
    <message>
        <source>± %1 µm (95 %)</source>
        <translation>± %1 µm (95 %)</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Höchstgeschw.</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>That strokes can reach between the margins</source>
        <translation>Die Hübe zwischen den Rändern erreichen können</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>± %1° (95 %)</source>
        <translation>± %1° (95 %)</translation>
    </message>
    <message>
        <source>Encoder count</source>
        <translation>Encoder-Stand</translation>
    </message>
    <message>
        <source>Find both ends and the index</source>
        <translation>Beide Enden und den Index finden</translation>
    </message>
    <message>
        <source>Find the index</source>
        <translation>Den Index finden</translation>
    </message>
    <message>
        <source>index at %1 mm</source>
        <translation>Index bei %1 mm</translation>
    </message>
    <message>
        <source>index ± %1°</source>
        <translation>Index ± %1°</translation>
    </message>
    <message>
        <source>Every place of the map is counted from the encoder&apos;s index.</source>
        <translation>Jede Stelle der Karte zählt vom Index des Encoders.</translation>
    </message>
    <message>
        <source>The motor is identified: about a minute, standing and then turning both ways.</source>
        <translation>Der Motor wird identifiziert: etwa eine Minute, im Stand und dann drehend in beiden Richtungen.</translation>
    </message>
    <message>
        <source>The shaft turns counter-clockwise at %1&#xa0;rad/s until the index is seen, at most %2&#xa0;turns.</source>
        <translation>Die Welle dreht linksherum mit %1&#xa0;rad/s, bis der Index kommt, höchstens %2&#xa0;Umdrehungen.</translation>
    </message>
    <message>
        <source>It backs off by %1° and passes the index&apos;s edge %2&#xa0;times at %3&#xa0;rad/s, always from the same side.</source>
        <translation>Sie geht um %1° zurück und überfährt die Kante des Index %2-mal mit %3&#xa0;rad/s, immer von derselben Seite.</translation>
    </message>
    <message>
        <source>It gives up after %1&#xa0;s.</source>
        <translation>Nach %1&#xa0;s gibt sie auf.</translation>
    </message>
    <message>
        <source>It runs over the whole travel to see the index once and only once, and passes it slowly from below three times.</source>
        <translation>Sie fährt über den ganzen Weg, um den Index genau einmal zu sehen, und überfährt ihn dreimal langsam von unten.</translation>
    </message>
    <message>
        <source>In the board&apos;s own angle, whole turns left out; mean over the passes</source>
        <translation>Im eigenen Winkel des Boards, ohne ganze Umdrehungen; Mittel über die Durchgänge</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
</context>
<context>
    <name>breakaway::IdentifyPage</name>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Motor identifizieren</translation>
    </message>
    <message>
        <source>Check the wiring</source>
        <translation>Leitungen prüfen</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Wiring</source>
        <translation>Verdrahtung</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%1 von %2 bestanden</translation>
    </message>
    <message>
        <source>Not identified yet</source>
        <translation>Noch nicht identifiziert</translation>
    </message>
    <message>
        <source>Force constant</source>
        <translation>Kraftkonstante</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>Drehmomentkonstante</translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>Ω</source>
        <translation>Ω</translation>
    </message>
    <message>
        <source>Inductance</source>
        <translation>Induktivität</translation>
    </message>
    <message>
        <source>mH</source>
        <translation>mH</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheitsmoment</translation>
    </message>
    <message>
        <source>Coulomb friction</source>
        <translation>Coulomb-Reibung</translation>
    </message>
    <message>
        <source>Mean of both ways</source>
        <translation>Mittel beider Richtungen</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Viskose Reibung</translation>
    </message>
    <message>
        <source>Dead zone of the bridge</source>
        <translation>Totzone der Brücke</translation>
    </message>
    <message>
        <source>mV</source>
        <translation>mV</translation>
    </message>
    <message>
        <source>Not checked yet</source>
        <translation>Noch nicht geprüft</translation>
    </message>
    <message>
        <source>Measure the motor&apos;s constants, its inertia, and what the current sensor&apos;s scale is worth</source>
        <translation>Die Konstanten des Motors, seine Trägheit, und was der Maßstab des Stromsensors wert ist, messen</translation>
    </message>
    <message>
        <source>A few small pulses tell whether motor, encoder and current sensor belong together; the shaft moves by a tenth of a turn at most</source>
        <translation>Einige kleine Impulse sagen, ob Motor, Encoder und Stromsensor zusammengehören; die Welle bewegt sich höchstens um eine Zehntelumdrehung</translation>
    </message>
    <message>
        <source>Each step says what it moves; nothing is written to the board.</source>
        <translation>Jeder Schritt sagt, was er bewegt; auf das Board wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Einstellen</translation>
    </message>
    <message>
        <source>%1, believed</source>
        <translation>%1, gesetzt</translation>
    </message>
</context>
<context>
    <name>breakaway::KeptMapsCard</name>
    <message>
        <source>Maps</source>
        <translation>Karten</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Today&apos;s</source>
        <translation>Die heutige</translation>
    </message>
    <message>
        <source>Beneath</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Choose in Runs…</source>
        <translation>In Läufe wählen…</translation>
    </message>
    <message>
        <source>A map of the project is opened or laid beneath there</source>
        <translation>Dort wird eine Karte des Projekts geöffnet oder darunter gelegt</translation>
    </message>
    <message>
        <source>today&apos;s</source>
        <translation>die heutige</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Shows what is measured at this bench again</source>
        <translation>Zeigt wieder, was an diesem Prüfstand gemessen ist</translation>
    </message>
    <message>
        <source>It is what is shown</source>
        <translation>Sie ist das, was gezeigt wird</translation>
    </message>
    <message>
        <source>Takes the earlier map away</source>
        <translation>Nimmt die frühere Karte weg</translation>
    </message>
    <message>
        <source>No map lies beneath</source>
        <translation>Keine Karte liegt darunter</translation>
    </message>
</context>
<context>
    <name>breakaway::LiveCursors</name>
    <message>
        <source>A %1   B %2   Δy %3</source>
        <translation>A %1   B %2   Δy %3</translation>
    </message>
    <message>
        <source>Δt %1 s</source>
        <translation>Δt %1 s</translation>
    </message>
    <message>
        <source>%1   A %2 s   B %3 s</source>
        <translation>%1   A %2 s   B %3 s</translation>
    </message>
</context>
<context>
    <name>breakaway::LivePlots</name>
    <message>
        <source>Live plots of angle, velocity, current and estimated disturbance over time</source>
        <translation>Live-Kurven von Winkel, Geschwindigkeit, Strom und geschätzter Störgröße über der Zeit</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Nothing to export: no sample is visible</source>
        <translation>Nichts auszugeben: kein Messwert ist sichtbar</translation>
    </message>
    <message>
        <source>Export the visible stretch</source>
        <translation>Den sichtbaren Abschnitt ausgeben</translation>
    </message>
    <message>
        <source>Recording (*.csv)</source>
        <translation>Aufzeichnung (*.csv)</translation>
    </message>
    <message>
        <source>%1 samples written to %2</source>
        <translation>%1 Messwerte nach %2 geschrieben</translation>
    </message>
    <message>
        <source>P holds the picture still, C shows the cursors, S the spectrum, L enlarges, R records</source>
        <translation>P hält das Bild still, C zeigt die Marken, S das Spektrum, L vergrößert, R zeichnet auf</translation>
    </message>
</context>
<context>
    <name>breakaway::LiveSamples</name>
    <message>
        <source>Recorded %1 samples</source>
        <translation>%1 Messwerte aufgezeichnet</translation>
    </message>
    <message>
        <source>The recording is written to %1</source>
        <translation>Die Aufzeichnung ist nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Kept in the project: %1</source>
        <translation>Im Projekt: %1</translation>
    </message>
    <message>
        <source>%1, then %2; what was recorded is kept</source>
        <translation>%1, dann %2; das Aufgezeichnete bleibt</translation>
    </message>
</context>
<context>
    <name>breakaway::LiveSpectrum</name>
    <message>
        <source>Hann</source>
        <translation>Hann</translation>
    </message>
    <message>
        <source>Blackman-Harris</source>
        <translation>Blackman-Harris</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>Flat-Top</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Channel of the spectrum</source>
        <translation>Kanal des Spektrums</translation>
    </message>
    <message>
        <source>Of which channel the spectrum is</source>
        <translation>Von welchem Kanal das Spektrum ist</translation>
    </message>
    <message>
        <source>Window function of the spectrum</source>
        <translation>Fensterfunktion des Spektrums</translation>
    </message>
    <message>
        <source>Hann: for most. Blackman-Harris: weak lines beside strong ones. Flat top: heights as they are without reading between lines. Rectangle: lines as narrow as they can be, with much beside them</source>
        <translation>Hann: für das meiste. Blackman-Harris: schwache Linien neben starken. Flat-Top: Höhen, wie sie sind, ohne zwischen Linien zu lesen. Rechteck: so schmale Linien wie möglich, mit viel daneben</translation>
    </message>
    <message>
        <source>Highest line of the spectrum</source>
        <translation>Höchste Linie des Spektrums</translation>
    </message>
    <message>
        <source>Amplitude spectrum of what the live plots show</source>
        <translation>Amplitudenspektrum dessen, was die Live-Bilder zeigen</translation>
    </message>
    <message>
        <source>Wheel and mouse choose the frequencies, a double click shows all of them</source>
        <translation>Rad und Maus wählen die Frequenzen, ein Doppelklick zeigt alle</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>Frequenz (Hz)</translation>
    </message>
    <message>
        <source>amplitude (%1)</source>
        <translation>Amplitude (%1)</translation>
    </message>
    <message>
        <source>Waits for samples</source>
        <translation>Wartet auf Messwerte</translation>
    </message>
    <message>
        <source>Nothing but zero in %1 s</source>
        <translation>Nichts als null in %1 s</translation>
    </message>
    <message>
        <source>Highest %1 Hz: %2 %3</source>
        <translation>Höchste %1 Hz: %2 %3</translation>
    </message>
    <message>
        <source>, order %1 of the rotor at %2 turns/s</source>
        <translation>, Ordnung %1 des Rotors bei %2 U/s</translation>
    </message>
</context>
<context>
    <name>breakaway::LiveStrip</name>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Plots of what comes from the board, below the page (Ctrl+L)</source>
        <translation>Kurven dessen, was vom Board kommt, unter der Seite (Strg+L)</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>What was said so far</source>
        <translation>Was bisher gesagt wurde</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Log: %1 new</source>
        <translation>Log: %1 neu</translation>
    </message>
</context>
<context>
    <name>breakaway::LiveToolbar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Hold the picture still; samples keep coming in (P in the plot)</source>
        <translation>Das Bild stillhalten; Messwerte kommen weiter herein (P im Bild)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Two cursors A and B over all plots (C in the plot): drag them, or move A with the arrow keys and B with Shift</source>
        <translation>Zwei Marken A und B über allen Kurven (C im Bild): mit der Maus ziehen, oder A mit den Pfeiltasten und B mit Umschalt bewegen</translation>
    </message>
    <message>
        <source>Visible time span</source>
        <translation>Sichtbare Zeitspanne</translation>
    </message>
    <message>
        <source>Visible time span; while the picture is paused, the wheel zooms</source>
        <translation>Sichtbare Zeitspanne; steht das Bild, zoomt das Mausrad</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Export visible…</source>
        <translation>Bild als CSV…</translation>
    </message>
    <message>
        <source>Write the visible stretch as CSV, every sample of it</source>
        <translation>Den sichtbaren Abschnitt als CSV schreiben, jeden seiner Messwerte</translation>
    </message>
    <message>
        <source>Save recording…</source>
        <translation>Aufz. speichern…</translation>
    </message>
    <message>
        <source>Write the last recording as CSV</source>
        <translation>Die letzte Aufzeichnung als CSV schreiben</translation>
    </message>
    <message>
        <source>Record every sample at the full rate, on the disk (R in the plot)</source>
        <translation>Jeden Messwert in voller Rate aufzeichnen, auf die Platte (R im Bild)</translation>
    </message>
    <message>
        <source>No board is connected</source>
        <translation>Kein Board ist verbunden</translation>
    </message>
    <message>
        <source>No sample has come yet</source>
        <translation>Noch ist kein Messwert gekommen</translation>
    </message>
    <message>
        <source>Nothing was recorded yet</source>
        <translation>Noch wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>Finish (%1 s)</source>
        <translation>Beenden (%1 s)</translation>
    </message>
    <message>
        <source>Save the last recording</source>
        <translation>Die letzte Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Recording (*.csv)</source>
        <translation>Aufzeichnung (*.csv)</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>The frequencies of what is visible, of any channel (S in the plot)</source>
        <translation>Die Frequenzen dessen, was sichtbar ist, von jedem Kanal (S im Bild)</translation>
    </message>
    <message>
        <source>Large</source>
        <translation>Groß</translation>
    </message>
    <message>
        <source>The plots take the page&apos;s place, until this is pressed again (L in the plot)</source>
        <translation>Die Bilder nehmen den Platz der Seite ein, bis hier wieder gedrückt wird (L im Bild)</translation>
    </message>
</context>
<context>
    <name>breakaway::LiveTrigger</name>
    <message>
        <source>Trigger</source>
        <translation>Auslöser</translation>
    </message>
    <message>
        <source>Auto: the picture stands at the newest edge and runs on without one. Single: it waits for one edge and pauses there; Pause arms it again</source>
        <translation>Auto: das Bild steht bei der neuesten Flanke und läuft ohne sie weiter. Einzeln: es wartet auf eine Flanke und hält dort an; Pause schärft neu</translation>
    </message>
    <message>
        <source>Free run</source>
        <translation>Freilauf</translation>
    </message>
    <message>
        <source>Trigger: auto</source>
        <translation>Auslöser: auto</translation>
    </message>
    <message>
        <source>Trigger: single</source>
        <translation>Auslöser: einzeln</translation>
    </message>
    <message>
        <source>Channel of the trigger</source>
        <translation>Kanal des Auslösers</translation>
    </message>
    <message>
        <source>What the trigger watches</source>
        <translation>Was der Auslöser beobachtet</translation>
    </message>
    <message>
        <source>Edge of the trigger</source>
        <translation>Flanke des Auslösers</translation>
    </message>
    <message>
        <source>Which way the channel crosses the level</source>
        <translation>In welcher Richtung der Kanal den Pegel kreuzt</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>Level of the trigger</source>
        <translation>Pegel des Auslösers</translation>
    </message>
    <message>
        <source>The level that the channel crosses, drawn over its plot</source>
        <translation>Der Pegel, den der Kanal kreuzt, über seine Kurve gezeichnet</translation>
    </message>
    <message>
        <source>through</source>
        <translation>durch</translation>
    </message>
    <message>
        <source>waits for an edge</source>
        <translation>wartet auf Flanke</translation>
    </message>
    <message>
        <source>edge at %1 s</source>
        <translation>Flanke bei %1 s</translation>
    </message>
</context>
<context>
    <name>breakaway::LocusPlot</name>
    <message>
        <source>Poles of the closed loop as the observer&apos;s cutoff grows</source>
        <translation>Pole des geschlossenen Kreises mit wachsender Grenzfrequenz des Beobachters</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>ζ 0.7</source>
        <translation>ζ 0.7</translation>
    </message>
</context>
<context>
    <name>breakaway::LogDrawer</name>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Trouble only</source>
        <translation>Nur Störungen</translation>
    </message>
    <message>
        <source>Show only what failed</source>
        <translation>Nur zeigen, was fehlgeschlagen ist</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the lines that are shown, with their times</source>
        <translation>Die gezeigten Zeilen mit ihren Uhrzeiten kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the log</source>
        <translation>Das Log schließen</translation>
    </message>
    <message>
        <source>What was said so far</source>
        <translation>Was bisher gesagt wurde</translation>
    </message>
    <message>
        <source>What was said so far, the newest on top; a chosen line is shown whole</source>
        <translation>Was bisher gesagt wurde, das Neueste oben; eine gewählte Zeile steht ganz da</translation>
    </message>
</context>
<context>
    <name>breakaway::LogPanel</name>
    <message>
        <source>Columns of the log as they are understood</source>
        <translation>Spalten des Protokolls, wie sie verstanden werden</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Taken as</source>
        <translation>Verstanden als</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>First values</source>
        <translation>Erste Werte</translation>
    </message>
    <message>
        <source>from file</source>
        <translation>aus Datei</translation>
    </message>
    <message>
        <source>Parted by</source>
        <translation>Geteilt nach</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Counts a turn</source>
        <translation>Inkr. je U</translation>
    </message>
    <message>
        <source>Pole pairs</source>
        <translation>Polpaare</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>Open as a recording</source>
        <translation>So öffnen</translation>
    </message>
    <message>
        <source>As guessed</source>
        <translation>Wie geraten</translation>
    </message>
    <message>
        <source>Forget all that was corrected for logs with these column names</source>
        <translation>Alles vergessen, was für Protokolle mit diesen Spaltennamen berichtigt wurde</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Open nothing</source>
        <translation>Nichts öffnen</translation>
    </message>
    <message>
        <source>%1, as it is understood</source>
        <translation>%1, wie es verstanden wird</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Opens it, and remembers what was corrected for logs with these column names</source>
        <translation>Öffnet es und merkt sich, was für Protokolle mit diesen Spaltennamen berichtigt wurde</translation>
    </message>
    <message>
        <source>It is being read</source>
        <translation>Es wird gelesen</translation>
    </message>
    <message>
        <source>a guess: %1</source>
        <translation>geraten: %1</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 is taken as</source>
        <translation>%1 ist verstanden als</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Einheit von %1</translation>
    </message>
    <message>
        <source>Rows apart (s)</source>
        <translation>Zeilen alle (s)</translation>
    </message>
    <message>
        <source>In recordings: %1</source>
        <translation>In Aufzeichnungen: %1</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Wird weggelassen</translation>
    </message>
    <message>
        <source>; say it here</source>
        <translation>; hier angeben</translation>
    </message>
</context>
<context>
    <name>breakaway::MainWindow</name>
    <message>
        <source>The language changes once the motor stands</source>
        <translation>Die Sprache wechselt, sobald der Motor steht</translation>
    </message>
    <message>
        <source>The language changes once the open question is answered</source>
        <translation>Die Sprache wechselt, sobald die offene Frage beantwortet ist</translation>
    </message>
</context>
<context>
    <name>breakaway::Manual</name>
    <message>
        <source>The manual</source>
        <translation>Das Handbuch</translation>
    </message>
    <message>
        <source>Links lead to other pages</source>
        <translation>Verweise führen zu anderen Seiten</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>The manual&apos;s first page</source>
        <translation>Die erste Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the manual</source>
        <translation>Schließt das Handbuch</translation>
    </message>
    <message>
        <source>The manual is not installed: %1 is missing</source>
        <translation>Das Handbuch ist nicht installiert: %1 fehlt</translation>
    </message>
</context>
<context>
    <name>breakaway::MapExport</name>
    <message>
        <source>What is written, and as what</source>
        <translation>Was geschrieben wird, und als was</translation>
    </message>
    <message>
        <source>Form of the export</source>
        <translation>Form der Ausgabe</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>There is no map yet: run the breakaway sweep to its end</source>
        <translation>Noch gibt es keine Karte: die Losbrechfahrt zu Ende fahren</translation>
    </message>
    <message>
        <source>Nothing was measured yet</source>
        <translation>Noch wurde nichts gemessen</translation>
    </message>
    <message>
        <source>Write the file</source>
        <translation>Die Datei schreiben</translation>
    </message>
    <message>
        <source>Export the friction map</source>
        <translation>Die Reibungskarte ausgeben</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Map as CSV</source>
        <translation>Karte als CSV</translation>
    </message>
    <message>
        <source>Map as JSON</source>
        <translation>Karte als JSON</translation>
    </message>
    <message>
        <source>Map as C header</source>
        <translation>Karte als C-Header</translation>
    </message>
    <message>
        <source>Map as MATLAB file</source>
        <translation>Karte für MATLAB</translation>
    </message>
    <message>
        <source>Picture as PNG</source>
        <translation>Bild als PNG</translation>
    </message>
    <message>
        <source>Picture as SVG</source>
        <translation>Bild als SVG</translation>
    </message>
    <message>
        <source>All breakaways as CSV</source>
        <translation>Losbrechungen, CSV</translation>
    </message>
</context>
<context>
    <name>breakaway::MapPanel</name>
    <message>
        <source>From zero</source>
        <translation>Ab null</translation>
    </message>
    <message>
        <source>Whether the scale begins at zero, or below the least value, so that variation is easier to see</source>
        <translation>Ob der Maßstab bei null beginnt, oder unter dem kleinsten Wert, sodass Schwankungen besser zu sehen sind</translation>
    </message>
    <message>
        <source>Whether the radius begins at zero, or below the least value, so that variation is easier to see</source>
        <translation>Ob der Radius bei null beginnt, oder unter dem kleinsten Wert, sodass Schwankungen besser zu sehen sind</translation>
    </message>
    <message>
        <source>Whether the curves %1 are shown</source>
        <translation>Ob die Kurven „%1“ gezeigt werden</translation>
    </message>
    <message>
        <source>Nothing measured yet</source>
        <translation>Noch wurde nichts gemessen</translation>
    </message>
    <message>
        <source>%1 over the travel</source>
        <translation>%1 über dem Weg</translation>
    </message>
    <message>
        <source>Over rotor angle (%1)</source>
        <translation>Über dem Rotorwinkel (%1)</translation>
    </message>
    <message>
        <source>A sweep homes first; then the map grows here</source>
        <translation>Eine Fahrt beginnt mit der Referenzfahrt; dann wächst die Karte hier</translation>
    </message>
    <message>
        <source>Point at the plot, or use its arrow keys, to read a value</source>
        <translation>Zum Ablesen auf das Bild zeigen, oder seine Pfeiltasten benutzen</translation>
    </message>
    <message>
        <source>mean, both ways</source>
        <translation>Mittel, beide Richtungen</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>earlier</source>
        <translation>früher</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>nothing measured yet</source>
        <translation>noch nichts gemessen</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Run breakaway sweep</source>
        <translation>Losbrechfahrt starten</translation>
    </message>
    <message>
        <source>Harmonics (%1)</source>
        <translation>Ordnungen (%1)</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>the map begins after homing</source>
        <translation>die Karte beginnt nach der Referenzfahrt</translation>
    </message>
    <message>
        <source>The same curves over the angle, from the first breakaways on: Run breakaway sweep</source>
        <translation>Dieselben Kurven über dem Winkel, ab den ersten Losbrechungen: Losbrechfahrt fahren</translation>
    </message>
    <message>
        <source>How often a turn the friction rises, as from poles or a shaft off its centre: comes with the first whole turn</source>
        <translation>Wie oft je Umdrehung die Reibung steigt, etwa durch Pole oder eine schiefe Welle: kommt mit der ersten ganzen Umdrehung</translation>
    </message>
    <message>
        <source>The map grows here, breakaway by breakaway</source>
        <translation>Hier wächst die Karte, Losbrechen um Losbrechen</translation>
    </message>
    <message>
        <source>the map begins after the speeds</source>
        <translation>nach der Geschw.-Fahrt</translation>
    </message>
    <message>
        <source>mean so far</source>
        <translation>Mittel bisher</translation>
    </message>
</context>
<context>
    <name>breakaway::MapPlot</name>
    <message>
        <source>Point at it, or use the arrow keys, to read a value</source>
        <translation>Zum Ablesen darauf zeigen, oder die Pfeiltasten benutzen</translation>
    </message>
    <message>
        <source>%1 at %2: %3</source>
        <translation>%1 bei %2: %3</translation>
    </message>
</context>
<context>
    <name>breakaway::MotorTestsPlot</name>
    <message>
        <source>What the motor was identified from: points as measured, lines as identified</source>
        <translation>Woraus der Motor bestimmt wurde: Punkte wie gemessen, Linien wie bestimmt</translation>
    </message>
    <message>
        <source>Standing: current (A) over voltage (V)</source>
        <translation>Im Stand: Strom (A) über Spannung (V)</translation>
    </message>
    <message>
        <source>Turning: back-EMF (V) over %1</source>
        <translation>In Bewegung: Gegenspannung (V) über %1</translation>
    </message>
    <message>
        <source>Identify the motor: what it shows standing and turning is drawn here</source>
        <translation>Motor identifizieren: was er im Stand und in Bewegung zeigt, steht dann hier</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Überblick</translation>
    </message>
    <message>
        <source>The line of the standing motor, and that of the turning one</source>
        <translation>Die Gerade des stehenden Motors, und die des drehenden</translation>
    </message>
    <message>
        <source>Winding</source>
        <translation>Wicklung</translation>
    </message>
    <message>
        <source>Current over voltage, and what the line leaves of it</source>
        <translation>Strom über Spannung, und was die Gerade davon übrig lässt</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>How fast the motor turned, and its back-EMF</source>
        <translation>Wie schnell der Motor drehte, und seine Gegenspannung</translation>
    </message>
    <message>
        <source>Reversal</source>
        <translation>Umkehr</translation>
    </message>
    <message>
        <source>Speed and current, and the speed that the inertia foretells</source>
        <translation>Geschwindigkeit und Strom, und die Geschwindigkeit, die das Trägheitsmoment vorhersagt</translation>
    </message>
    <message>
        <source>Not measured yet</source>
        <translation>Noch nicht gemessen</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Hübe</translation>
    </message>
    <message>
        <source>Speed (%1) over time (s)</source>
        <translation>Geschwindigkeit (%1) über Zeit (s)</translation>
    </message>
    <message>
        <source>What the line leaves of the current (mA) over voltage (V)</source>
        <translation>Was die Gerade vom Strom übrig lässt (mA) über Spannung (V)</translation>
    </message>
    <message>
        <source>Current (A) over time (s)</source>
        <translation>Strom (A) über Zeit (s)</translation>
    </message>
</context>
<context>
    <name>breakaway::ObserverNoisePlot</name>
    <message>
        <source>Noise of the current over the speed observer&apos;s bandwidth</source>
        <translation>Rauschen des Stroms über der Bandbreite des Geschwindigkeitsbeobachters</translation>
    </message>
    <message>
        <source>board: %1 rad/s</source>
        <translation>Board: %1 rad/s</translation>
    </message>
</context>
<context>
    <name>breakaway::Page</name>
    <message>
        <source>Reading</source>
        <translation>Ablesung</translation>
    </message>
</context>
<context>
    <name>breakaway::ParametersDock</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the parameters; edits stay (Ctrl+P)</source>
        <translation>Die Parameter schließen; Änderungen bleiben (Strg+P)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Revert all</source>
        <translation>Alle verwerfen</translation>
    </message>
    <message>
        <source>Profile…</source>
        <translation>Profil…</translation>
    </message>
    <message>
        <source>Take ticked</source>
        <translation>Angekreuzte</translation>
    </message>
    <message>
        <source>Lay a profile beside the board</source>
        <translation>Ein Profil neben das Board legen</translation>
    </message>
    <message>
        <source>Profile (*.profile.json *.json)</source>
        <translation>Profil (*.profile.json *.json)</translation>
    </message>
    <message>
        <source>The board&apos;s settings</source>
        <translation>Die Einstellungen des Boards</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>At first</source>
        <translation>Anfangs</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>F2 or a double click edits; nothing is sent before Apply</source>
        <translation>F2 oder ein Doppelklick ändert; vor dem Übernehmen wird nichts gesendet</translation>
    </message>
    <message>
        <source>What the board had when it was connected; boards don&apos;t say what their defaults are</source>
        <translation>Was das Board beim Verbinden hatte; Boards sagen nicht, was ihre Werkseinstellungen sind</translation>
    </message>
    <message>
        <source>Apply ticked</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>not offered</source>
        <translation>nicht angeboten</translation>
    </message>
    <message>
        <source>No board is connected</source>
        <translation>Kein Board ist verbunden</translation>
    </message>
    <message>
        <source>This board keeps the setting to itself: its maker&apos;s tool sets it</source>
        <translation>Dieses Board behält die Einstellung für sich: das Programm seines Herstellers setzt sie</translation>
    </message>
    <message>
        <source>%1: %2 is not within %3 %4; the value stays as it was</source>
        <translation>%1: %2 liegt nicht in %3 %4; der Wert bleibt, wie er war</translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>There is no edit to take back</source>
        <translation>Es gibt keine Änderung zurückzunehmen</translation>
    </message>
    <message>
        <source>Make the edit again that was taken back</source>
        <translation>Die zurückgenommene Änderung wieder machen</translation>
    </message>
    <message>
        <source>No edit was taken back</source>
        <translation>Keine Änderung wurde zurückgenommen</translation>
    </message>
    <message>
        <source>Back to what the board has, in the chosen row</source>
        <translation>Zurück zu dem, was das Board hat, in der gewählten Zeile</translation>
    </message>
    <message>
        <source>The chosen row is not edited</source>
        <translation>Die gewählte Zeile ist nicht geändert</translation>
    </message>
    <message>
        <source>Back to what the board has, in every row</source>
        <translation>Zurück zu dem, was das Board hat, in jeder Zeile</translation>
    </message>
    <message>
        <source>Nothing is edited</source>
        <translation>Nichts ist geändert</translation>
    </message>
    <message>
        <source>Show what a saved profile holds beside the board; nothing is changed by it</source>
        <translation>Zeigt neben dem Board, was ein gespeichertes Profil enthält; nichts wird dadurch geändert</translation>
    </message>
    <message>
        <source>Edit the ticked rows to what the profile holds; Apply sends them</source>
        <translation>Die angekreuzten Zeilen auf die Werte des Profils ändern; Übernehmen sendet sie</translation>
    </message>
    <message>
        <source>No row that differs from the profile is ticked</source>
        <translation>Keine Zeile, die vom Profil abweicht, ist angekreuzt</translation>
    </message>
    <message>
        <source>No profile is open</source>
        <translation>Kein Profil ist offen</translation>
    </message>
    <message>
        <source>Send the ticked edits to the board; what it accepts is shown</source>
        <translation>Die angekreuzten Änderungen ans Board senden; was es annimmt, wird gezeigt</translation>
    </message>
    <message>
        <source>No edited row is ticked</source>
        <translation>Keine geänderte Zeile ist angekreuzt</translation>
    </message>
    <message>
        <source>Nothing is edited: the board has what is shown</source>
        <translation>Nichts ist geändert: das Board hat, was gezeigt wird</translation>
    </message>
    <message>
        <source>Choose a row to read what it is; F2 or a double click edits it.</source>
        <translation>Eine Zeile wählen, um zu lesen, was sie ist; F2 oder ein Doppelklick ändert sie.</translation>
    </message>
    <message>
        <source>No board is connected.</source>
        <translation>Kein Board ist verbunden.</translation>
    </message>
    <message>
        <source>%1: %2 %3 %4.</source>
        <translation>%1: %2 %3 %4.</translation>
    </message>
    <message>
        <source>%1: this board keeps it to itself; its maker&apos;s tool sets it.</source>
        <translation>%1: dieses Board behält sie für sich; das Programm seines Herstellers setzt sie.</translation>
    </message>
</context>
<context>
    <name>breakaway::PolarPlot</name>
    <message>
        <source>Polar plot around the rotor; arrow keys read the points</source>
        <translation>Polarbild rund um den Rotor; die Pfeiltasten lesen die Punkte</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
</context>
<context>
    <name>breakaway::ProfileComparison</name>
    <message>
        <source>No board is connected</source>
        <translation>Kein Board ist verbunden</translation>
    </message>
    <message>
        <source>Profiles are for boards with a rotor; this one moves a linear axis</source>
        <translation>Profile sind für Boards mit Rotor; dieses bewegt eine lineare Achse</translation>
    </message>
    <message>
        <source>%1, saved from %2 (%3)</source>
        <translation>%1, gespeichert von %2 (%3)</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 ist geschrieben</translation>
    </message>
    <message>
        <source>The board accepted all that was asked for</source>
        <translation>Das Board hat alles angenommen, was verlangt war</translation>
    </message>
    <message>
        <source>The board took %1 of %2 parameters otherwise than asked for: see the table</source>
        <translation>Das Board hat %1 von %2 Parametern anders angenommen als verlangt: siehe Tabelle</translation>
    </message>
</context>
<context>
    <name>breakaway::ProfilePanel</name>
    <message>
        <source>Friction table</source>
        <translation>Reibungstabelle</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>Vergleichen mit…</translation>
    </message>
    <message>
        <source>Restore ticked</source>
        <translation>Angekreuzte zurück</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Save the profile</source>
        <translation>Das Profil speichern</translation>
    </message>
    <message>
        <source>Profile (*.profile.json)</source>
        <translation>Profil (*.profile.json)</translation>
    </message>
    <message>
        <source>Compare with a profile</source>
        <translation>Mit einem Profil vergleichen</translation>
    </message>
    <message>
        <source>Profile (*.profile.json *.json)</source>
        <translation>Profil (*.profile.json *.json)</translation>
    </message>
    <message>
        <source>%1 in the file</source>
        <translation>%1 in der Datei</translation>
    </message>
    <message>
        <source>%1: nothing differs</source>
        <translation>%1: nichts weicht ab</translation>
    </message>
    <message>
        <source>Write gains, limits and the friction table of this board to a file</source>
        <translation>Verstärkungen, Grenzen und die Reibungstabelle dieses Boards in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Show where a saved profile differs from the board; nothing is written</source>
        <translation>Zeigen, wo ein gespeichertes Profil vom Board abweicht; nichts wird geschrieben</translation>
    </message>
    <message>
        <source>No profile is open: compare with one first</source>
        <translation>Kein Profil ist offen: erst mit einem vergleichen</translation>
    </message>
    <message>
        <source>No parameter is ticked</source>
        <translation>Kein Parameter ist angekreuzt</translation>
    </message>
    <message>
        <source>Ask the board for the profile&apos;s values of the ticked parameters</source>
        <translation>Vom Board die Werte des Profils für die angekreuzten Parameter verlangen</translation>
    </message>
    <message>
        <source>A profile is a file with the gains, limits and friction table of a board: save this board&apos;s, or see where a saved one differs. Nothing is written unasked.</source>
        <translation>Ein Profil ist eine Datei mit Verstärkungen, Grenzen und Reibungstabelle eines Boards: die dieses Boards speichern, oder sehen, worin sich ein gespeichertes unterscheidet. Nichts wird ungefragt geschrieben.</translation>
    </message>
    <message>
        <source>Parameters of the board, or those that differ from the profile</source>
        <translation>Parameter des Boards, oder die vom Profil abweichenden</translation>
    </message>
</context>
<context>
    <name>breakaway::ProjectRuns</name>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>The recording is written to %1</source>
        <translation>Die Aufzeichnung ist nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>breakaway::QuantitySlider</name>
    <message>
        <source>edited; on board %1</source>
        <translation>geändert; Board: %1</translation>
    </message>
    <message>
        <source>as on board</source>
        <translation>wie auf dem Board</translation>
    </message>
</context>
<context>
    <name>breakaway::Rail</name>
    <message>
        <source>Steps of the job</source>
        <translation>Schritte der Arbeit</translation>
    </message>
    <message>
        <source>Steps of the job; Ctrl and a number goes to one</source>
        <translation>Schritte der Arbeit; Strg und eine Zahl führt zu einem</translation>
    </message>
</context>
<context>
    <name>breakaway::ReportPage</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>What was measured or compared, as a file to hand over.</source>
        <translation>Messung oder Vergleich als Datei zum Weitergeben.</translation>
    </message>
    <message>
        <source>Write friction report…</source>
        <translation>Bericht schreiben…</translation>
    </message>
    <message>
        <source>Write comparison…</source>
        <translation>Vergleich…</translation>
    </message>
    <message>
        <source>Write as PDF…</source>
        <translation>Als PDF…</translation>
    </message>
    <message>
        <source>Open the last one</source>
        <translation>Den letzten öffnen</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Vorschau des Berichts</translation>
    </message>
    <message>
        <source>The report as it will be written</source>
        <translation>Der Bericht, wie er geschrieben wird</translation>
    </message>
    <message>
        <source>No report was written yet</source>
        <translation>Noch wurde kein Bericht geschrieben</translation>
    </message>
    <message>
        <source>Report of</source>
        <translation>Bericht über</translation>
    </message>
    <message>
        <source>This motor</source>
        <translation>Diesen Motor</translation>
    </message>
    <message>
        <source>Friction, motor, and how they were measured</source>
        <translation>Reibung, Motor, und wie beides gemessen wurde</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>The diagnosis of the Compare page</source>
        <translation>Die Diagnose der Seite Vergleichen</translation>
    </message>
    <message>
        <source>For whom</source>
        <translation>Für wen</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kunde</translation>
    </message>
    <message>
        <source>Stands below the report&apos;s title</source>
        <translation>Steht unter dem Titel des Berichts</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Stand below the customer&apos;s name</source>
        <translation>Stehen unter dem Namen des Kunden</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>Which chapters are written; Enter ticks one</source>
        <translation>Welche Kapitel geschrieben werden; die Eingabetaste kreuzt eines an</translation>
    </message>
    <message>
        <source>Nothing was measured yet</source>
        <translation>Noch wurde nichts gemessen</translation>
    </message>
    <message>
        <source>Nothing was diagnosed yet</source>
        <translation>Noch wurde nichts diagnostiziert</translation>
    </message>
    <message>
        <source>Write one HTML file</source>
        <translation>Eine HTML-Datei schreiben</translation>
    </message>
    <message>
        <source>Choose a folder; it is created when it is new</source>
        <translation>Einen Ordner wählen; ist er neu, wird er angelegt</translation>
    </message>
    <message>
        <source>Write what is shown as A4 pages</source>
        <translation>Das Gezeigte als A4-Seiten schreiben</translation>
    </message>
    <message>
        <source>can be written</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>Nothing was measured yet. A sweep on the Friction page fills this report.</source>
        <translation>Noch wurde nichts gemessen. Eine Messfahrt auf der Seite Reibung füllt diesen Bericht.</translation>
    </message>
    <message>
        <source>Nothing was diagnosed yet. Diagnose on the Compare page fills this report.</source>
        <translation>Noch wurde nichts diagnostiziert. Die Diagnose auf der Seite Vergleichen füllt diesen Bericht.</translation>
    </message>
    <message>
        <source>Write the friction report</source>
        <translation>Den Reibungsbericht schreiben</translation>
    </message>
    <message>
        <source>Report (*.html)</source>
        <translation>Bericht (*.html)</translation>
    </message>
    <message>
        <source>Write the comparison&apos;s report into a folder</source>
        <translation>Den Bericht des Vergleichs in einen Ordner schreiben</translation>
    </message>
    <message>
        <source>Write the report as PDF</source>
        <translation>Den Bericht als PDF schreiben</translation>
    </message>
    <message>
        <source>Report (*.pdf)</source>
        <translation>Bericht (*.pdf)</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Language of the report</source>
        <translation>Sprache des Berichts</translation>
    </message>
    <message>
        <source>The language in which the report is written; files that programs read stay as they are</source>
        <translation>Die Sprache, in der der Bericht geschrieben wird; Dateien, die Programme lesen, bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>In the window&apos;s language</source>
        <translation>In der Sprache des Fensters</translation>
    </message>
    <message>
        <source>In English</source>
        <translation>Auf Englisch</translation>
    </message>
    <message>
        <source>In German</source>
        <translation>Auf Deutsch</translation>
    </message>
</context>
<context>
    <name>breakaway::ResidualPlots</name>
    <message>
        <source>Measurement over simulation, and the residual beneath</source>
        <translation>Messung über Simulation, und darunter das Residuum</translation>
    </message>
    <message>
        <source>Position (mm)</source>
        <translation>Lage (mm)</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>Winkel (°)</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>simulated with findings</source>
        <translation>simuliert mit Befunden</translation>
    </message>
    <message>
        <source>base model</source>
        <translation>Grundmodell</translation>
    </message>
    <message>
        <source>with findings</source>
        <translation>mit Befunden</translation>
    </message>
    <message>
        <source>this motion can&apos;t be foreseen: the torque counts</source>
        <translation>diese Bewegung ist nicht vorhersagbar: das Moment zählt</translation>
    </message>
    <message>
        <source>95 % of what a perfect model leaves</source>
        <translation>95 % dessen, was ein vollkommenes Modell übrig lässt</translation>
    </message>
    <message>
        <source>Force left (N) over %1</source>
        <translation>Restkraft (N) über %1</translation>
    </message>
    <message>
        <source>Torque left (mNm) over %1</source>
        <translation>Restmoment (mNm) über %1</translation>
    </message>
    <message>
        <source>Residual (mm) over %1</source>
        <translation>Residuum (mm) über %1</translation>
    </message>
    <message>
        <source>Residual (°) over %1</source>
        <translation>Residuum (°) über %1</translation>
    </message>
    <message>
        <source>Open or drop a recording and its bench file, or press Example</source>
        <translation>Aufzeichnung und Prüfstandsdatei öffnen oder herziehen, oder „Beispiel“</translation>
    </message>
    <message>
        <source>measured; dashed: %1</source>
        <translation>gemessen; gestrichelt: %1</translation>
    </message>
</context>
<context>
    <name>breakaway::RivalBars</name>
    <message>
        <source>Error on unseen data, with others in the place of this finding</source>
        <translation>Fehler auf ungesehenen Daten, mit anderen an der Stelle dieses Befundes</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation> (%1 bis %2)</translation>
    </message>
    <message>
        <source>, which can&apos;t be told from the finding&apos;s</source>
        <translation>, von dem des Befundes nicht zu unterscheiden</translation>
    </message>
    <message>
        <source>, %1 to %2 times the finding&apos;s</source>
        <translation>, %1- bis %2-mal der des Befundes</translation>
    </message>
</context>
<context>
    <name>breakaway::RotorDial</name>
    <message>
        <source>Rotor angle</source>
        <translation>Rotorwinkel</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>from the index</source>
        <translation>vom Index an</translation>
    </message>
    <message>
        <source>from power-up</source>
        <translation>vom Einschalten an</translation>
    </message>
    <message>
        <source>%1° to go at most</source>
        <translation>höchstens noch %1°</translation>
    </message>
</context>
<context>
    <name>breakaway::RunComparisonPanel</name>
    <message>
        <source>Write report…</source>
        <translation>Bericht schreiben…</translation>
    </message>
    <message>
        <source>One HTML file with both maps, the figures, and comparison.json, into a folder</source>
        <translation>Eine HTML-Datei mit beiden Karten, die Bilder und comparison.json, in einen Ordner</translation>
    </message>
    <message>
        <source>Back to the list</source>
        <translation>Zurück zur Liste</translation>
    </message>
    <message>
        <source>Shows the runs again</source>
        <translation>Zeigt wieder die Läufe</translation>
    </message>
    <message>
        <source>What has changed</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>What has changed between the two runs; bold lies beyond the 95 % intervals</source>
        <translation>Was sich zwischen den beiden Läufen geändert hat; Fettes liegt außerhalb der 95-%-Intervalle</translation>
    </message>
    <message>
        <source>Write the comparison of the runs into a folder</source>
        <translation>Den Vergleich der Läufe in einen Ordner schreiben</translation>
    </message>
</context>
<context>
    <name>breakaway::RunPanel</name>
    <message>
        <source>Activity</source>
        <translation>Tätigkeit</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Stopped: %1. What was measured is kept.</source>
        <translation>Angehalten: %1. Was gemessen wurde, bleibt.</translation>
    </message>
    <message>
        <source>How the last run ended, and what is next</source>
        <translation>Wie der letzte Lauf endete, und was als Nächstes kommt</translation>
    </message>
    <message>
        <source>Done. Next: %1</source>
        <translation>Fertig. Weiter: %1</translation>
    </message>
</context>
<context>
    <name>breakaway::RunsPage</name>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>All that was measured and found, kept by itself; this window&apos;s and the commands&apos;.</source>
        <translation>Alles Gemessene und Gefundene, von selbst aufbewahrt; von Fenster und Befehlen.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Compare two</source>
        <translation>Zwei vergleichen</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Text in a run</source>
        <translation>Text in einem Lauf</translation>
    </message>
    <message>
        <source>Name, remark, result, date</source>
        <translation>Name, Bemerkung, Datum</translation>
    </message>
    <message>
        <source>Only runs with this in their name, remark, folder, result or command</source>
        <translation>Nur Läufe mit diesem Text in Name, Bemerkung, Ordner, Ergebnis oder Befehl</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Only runs of this motor, by its serial number</source>
        <translation>Nur Läufe dieses Motors, nach seiner Seriennummer</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Only runs of this kind</source>
        <translation>Nur Läufe dieser Art</translation>
    </message>
    <message>
        <source>Every motor</source>
        <translation>Jeder Motor</translation>
    </message>
    <message>
        <source>Every kind</source>
        <translation>Jede Art</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Open report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>CSV speichern…</translation>
    </message>
    <message>
        <source>Lay beneath</source>
        <translation>Darunter legen</translation>
    </message>
    <message>
        <source>Nothing was kept yet. A sweep, a recording or a diagnosis comes here by itself.</source>
        <translation>Noch wurde nichts aufbewahrt. Eine Fahrt, eine Aufzeichnung oder eine Diagnose kommt von selbst hierher.</translation>
    </message>
    <message>
        <source>No run passes the filter.</source>
        <translation>Kein Lauf passt zum Filter.</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 Läufe</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 von %2 Läufen</translation>
    </message>
    <message>
        <source>nothing kept yet</source>
        <translation>noch nichts aufbewahrt</translation>
    </message>
    <message>
        <source>%1 kept</source>
        <translation>%1 aufbewahrt</translation>
    </message>
    <message>
        <source>Choose a run in the table</source>
        <translation>Einen Lauf in der Tabelle wählen</translation>
    </message>
    <message>
        <source>Folder of the project: %1</source>
        <translation>Ordner des Projekts: %1</translation>
    </message>
    <message>
        <source>%1 %2 with 95 % confidence</source>
        <translation>%1 %2 mit 95 % Sicherheit</translation>
    </message>
    <message>
        <source>Choose a run first</source>
        <translation>Erst einen Lauf wählen</translation>
    </message>
    <message>
        <source>Choose one run alone</source>
        <translation>Einen Lauf allein wählen</translation>
    </message>
    <message>
        <source>The run is being read</source>
        <translation>Der Lauf wird gelesen</translation>
    </message>
    <message>
        <source>It is being recorded</source>
        <translation>Er wird gerade aufgezeichnet</translation>
    </message>
    <message>
        <source>Shows the map on the Friction page</source>
        <translation>Zeigt die Karte auf der Seite Reibung</translation>
    </message>
    <message>
        <source>Shows the recording on the Compare page</source>
        <translation>Zeigt die Aufzeichnung auf der Seite Vergleichen</translation>
    </message>
    <message>
        <source>Shows the run&apos;s report</source>
        <translation>Zeigt den Bericht des Laufs</translation>
    </message>
    <message>
        <source>The run left nothing to show: its files lie in its folder</source>
        <translation>Der Lauf hat nichts zum Zeigen hinterlassen: seine Dateien liegen in seinem Ordner</translation>
    </message>
    <message>
        <source>Lays the map beneath the one on the Friction page, with a ring of their differences</source>
        <translation>Legt die Karte unter die auf der Seite Reibung, mit einem Ring ihrer Unterschiede</translation>
    </message>
    <message>
        <source>Opens the run&apos;s report in the browser</source>
        <translation>Öffnet den Bericht des Laufs im Browser</translation>
    </message>
    <message>
        <source>The run has no report</source>
        <translation>Der Lauf hat keinen Bericht</translation>
    </message>
    <message>
        <source>Writes the whole recording as CSV</source>
        <translation>Schreibt die ganze Aufzeichnung als CSV</translation>
    </message>
    <message>
        <source>The run has no recording</source>
        <translation>Der Lauf hat keine Aufzeichnung</translation>
    </message>
    <message>
        <source>What has changed between the two, beyond their intervals</source>
        <translation>Was sich zwischen den beiden über ihre Intervalle hinaus geändert hat</translation>
    </message>
    <message>
        <source>Choose two runs, with Ctrl or Shift</source>
        <translation>Zwei Läufe wählen, mit Strg oder Umschalt</translation>
    </message>
    <message>
        <source>Save the run&apos;s recording</source>
        <translation>Die Aufzeichnung des Laufs speichern</translation>
    </message>
    <message>
        <source>Recording (*.csv)</source>
        <translation>Aufzeichnung (*.csv)</translation>
    </message>
    <message>
        <source>Folder: %1</source>
        <translation>Ordner: %1</translation>
    </message>
    <message>
        <source>Draws the recording dashed beneath the one on the Compare page</source>
        <translation>Zeichnet die Aufnahme gestrichelt unter die auf der Seite Vergleichen</translation>
    </message>
    <message>
        <source>The run has neither a friction map nor a recording</source>
        <translation>Der Lauf hat weder Reibungskarte noch Aufnahme</translation>
    </message>
</context>
<context>
    <name>breakaway::RunsTable</name>
    <message>
        <source>%1
Double click or F2 to write</source>
        <translation>%1
Doppelklick oder F2 zum Schreiben</translation>
    </message>
    <message>
        <source>Runs of the project</source>
        <translation>Läufe des Projekts</translation>
    </message>
    <message>
        <source>Enter opens a run, F2 writes its name or remark, Shift chooses several</source>
        <translation>Die Eingabetaste öffnet einen Lauf, F2 schreibt Name oder Bemerkung, Umschalt wählt mehrere</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>breakaway::SecondsTicker</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>breakaway::SettingsEdits</name>
    <message>
        <source>The board took %1 of %2 settings otherwise than asked for; what it accepted is shown</source>
        <translation>Das Board hat %1 von %2 Einstellungen anders angenommen als verlangt; was es angenommen hat, wird gezeigt</translation>
    </message>
    <message>
        <source>%1, saved from %2</source>
        <translation>%1, gespeichert von %2</translation>
    </message>
</context>
<context>
    <name>breakaway::StepPlot</name>
    <message>
        <source>Velocity steps and their current over time, measured and foretold</source>
        <translation>Geschwindigkeitssprünge und ihr Strom über der Zeit, gemessen und vorhergesagt</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>Speed (%1)</source>
        <translation>Geschwindigkeit (%1)</translation>
    </message>
    <message>
        <source>Current (A) over the time from the step (ms)</source>
        <translation>Strom (A) über der Zeit ab dem Sprung (ms)</translation>
    </message>
    <message>
        <source>foretold</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Sprung %1</translation>
    </message>
    <message>
        <source>Connect a board:
the step that its settings make
is foretold here</source>
        <translation>Ein Board verbinden: hier
wird der Sprung vorhergesagt,
den seine Einstellungen ergeben</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>╌ on board</source>
        <translation>╌ Board</translation>
    </message>
</context>
<context>
    <name>breakaway::StepTable</name>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>Measured steps</source>
        <translation>Gemessene Sprünge</translation>
    </message>
    <message>
        <source>What is foretold, and the measured steps, the newest on top; settling to 5 %</source>
        <translation>Was vorhergesagt ist, und die gemessenen Sprünge, der neueste oben; Einschwingen auf 5 %</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Kp</source>
        <translation>Kp</translation>
    </message>
    <message>
        <source>Ki</source>
        <translation>Ki</translation>
    </message>
    <message>
        <source>g</source>
        <translation>g</translation>
    </message>
    <message>
        <source>Rise
ms</source>
        <translation>Anst.
ms</translation>
    </message>
    <message>
        <source>Over
%</source>
        <translation>Über
%</translation>
    </message>
    <message>
        <source>Settle
ms</source>
        <translation>Eins.
ms</translation>
    </message>
    <message>
        <source>Peak
A</source>
        <translation>Max.
A</translation>
    </message>
    <message>
        <source>Foretold</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Sprung %1</translation>
    </message>
    <message>
        <source>Foretold, or which measured one</source>
        <translation>Vorausgesagt, oder welcher gemessene</translation>
    </message>
    <message>
        <source>Proportional gain (%1)</source>
        <translation>Proportionalverstärkung (%1)</translation>
    </message>
    <message>
        <source>Integral gain (%1)</source>
        <translation>Integralverstärkung (%1)</translation>
    </message>
    <message>
        <source>Cutoff of the disturbance observer (rad/s)</source>
        <translation>Grenzfrequenz des Störbeobachters (rad/s)</translation>
    </message>
    <message>
        <source>Time from 10 to 90 % of the step</source>
        <translation>Zeit von 10 bis 90 % des Sprungs</translation>
    </message>
    <message>
        <source>Overshoot beyond the end, part of the step</source>
        <translation>Überschwingen über das Ende, Anteil am Sprung</translation>
    </message>
    <message>
        <source>Time until it stays within 5 % of the step</source>
        <translation>Zeit, bis er innerhalb von 5 % des Sprungs bleibt</translation>
    </message>
    <message>
        <source>Highest current</source>
        <translation>Höchster Strom</translation>
    </message>
</context>
<context>
    <name>breakaway::ThemeButton</name>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>System&apos;s language</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>Colours and language of the window</source>
        <translation>Farben und Sprache des Fensters</translation>
    </message>
    <message>
        <source>Colours of the window: light, dark, or as the desktop has them; and its language</source>
        <translation>Farben des Fensters: hell, dunkel, oder wie der Desktop sie hat; und seine Sprache</translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation>Farben: %1</translation>
    </message>
</context>
<context>
    <name>breakaway::Toast</name>
    <message>
        <source>Opens the log</source>
        <translation>Öffnet das Log</translation>
    </message>
    <message>
        <source>Last message</source>
        <translation>Letzte Meldung</translation>
    </message>
    <message>
        <source>%1
Click: shows it in the log</source>
        <translation>%1
Klick: zeigt es im Log</translation>
    </message>
</context>
<context>
    <name>breakaway::TravelPlot</name>
    <message>
        <source>Plot over the travel; arrow keys read the points</source>
        <translation>Bild über dem Weg; die Pfeiltasten lesen die Punkte</translation>
    </message>
    <message>
        <source>Plot over the rotor&apos;s angle; arrow keys read the points</source>
        <translation>Bild über dem Rotorwinkel; die Pfeiltasten lesen die Punkte</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>position from the index (mm)</source>
        <translation>Lage vom Index aus (mm)</translation>
    </message>
</context>
<context>
    <name>breakaway::TravelStrip</name>
    <message>
        <source>Position of the axis</source>
        <translation>Lage der Achse</translation>
    </message>
    <message>
        <source>mm from the index</source>
        <translation>mm vom Index an</translation>
    </message>
    <message>
        <source>mm from power-up</source>
        <translation>mm vom Einschalten an</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>breakaway::TrialRun</name>
    <message>
        <source>A trial is being recorded</source>
        <translation>Ein Versuch wird aufgezeichnet</translation>
    </message>
    <message>
        <source>A diagnosis is running</source>
        <translation>Eine Diagnose läuft</translation>
    </message>
    <message>
        <source>The command breakaway, which conceals and records, isn&apos;t installed</source>
        <translation>Der Befehl breakaway, der verbirgt und aufzeichnet, ist nicht installiert</translation>
    </message>
    <message>
        <source>The trial could not be recorded: %1</source>
        <translation>Der Versuch konnte nicht aufgezeichnet werden: %1</translation>
    </message>
    <message>
        <source>Trial %1 is recorded: what does it conceal?</source>
        <translation>Versuch %1 ist aufgezeichnet: was verbirgt er?</translation>
    </message>
    <message>
        <source>No sealed trial is open</source>
        <translation>Kein versiegelter Versuch ist offen</translation>
    </message>
    <message>
        <source>Diagnose first: the answer has to be in</source>
        <translation>Erst diagnostizieren: die Antwort muss gegeben sein</translation>
    </message>
    <message>
        <source>The trial&apos;s truth can&apos;t be read</source>
        <translation>Die Wahrheit des Versuchs lässt sich nicht lesen</translation>
    </message>
</context>
<context>
    <name>breakaway::TrialStrip</name>
    <message>
        <source>Nothing was concealed.</source>
        <translation>Nichts war verborgen.</translation>
    </message>
    <message>
        <source>Concealed was %1.</source>
        <translation>Verborgen war %1.</translation>
    </message>
    <message>
        <source>The catalogue has no name for it.</source>
        <translation>Der Katalog hat keinen Namen dafür.</translation>
    </message>
    <message>
        <source>The answer is right.</source>
        <translation>Die Antwort stimmt.</translation>
    </message>
    <message>
        <source>Missed: %1.</source>
        <translation>Übersehen: %1.</translation>
    </message>
    <message>
        <source>Wrong: %1.</source>
        <translation>Falsch: %1.</translation>
    </message>
    <message>
        <source>The answer is not right.</source>
        <translation>Die Antwort stimmt nicht.</translation>
    </message>
    <message>
        <source>Unseal</source>
        <translation>Entsiegeln</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>Versuch %1: %2</translation>
    </message>
    <message>
        <source>Trial %1 is sealed: the window has seen its bench and recordings alone.</source>
        <translation>Versuch %1 ist versiegelt: das Fenster hat nur seine Prüfstandsdatei und Aufzeichnungen gesehen.</translation>
    </message>
    <message>
        <source>Say what the trial concealed, beside the answer</source>
        <translation>Neben der Antwort sagen, was der Versuch verbarg</translation>
    </message>
    <message>
        <source>It is unsealed: what was concealed stands here</source>
        <translation>Es ist entsiegelt: hier steht, was verborgen war</translation>
    </message>
</context>
<context>
    <name>breakaway::TunePage</name>
    <message>
        <source>Tune</source>
        <translation>Einstellen</translation>
    </message>
    <message>
        <source>The step moves with the sliders; the board keeps its values until Apply.</source>
        <translation>Der Sprung folgt den Reglern; das Board erst dem Übernehmen.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Measure a step</source>
        <translation>Sprung messen</translation>
    </message>
    <message>
        <source>Clear steps</source>
        <translation>Sprünge leeren</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Steif</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Velocity loop</source>
        <translation>Geschwindigkeitskreis</translation>
    </message>
    <message>
        <source>Step from 0 to</source>
        <translation>Sprung von 0 auf</translation>
    </message>
    <message>
        <source>Velocity step</source>
        <translation>Geschwindigkeitssprung</translation>
    </message>
    <message>
        <source>From standstill to this velocity</source>
        <translation>Aus dem Stillstand auf diese Geschwindigkeit</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenrand</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Ampl.-Rand</translation>
    </message>
    <message>
        <source>αgT</source>
        <translation>αgT</translation>
    </message>
    <message>
        <source>Current noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Poles over g (1/s)</source>
        <translation>Pole über g (1/s)</translation>
    </message>
    <message>
        <source>Poles of the closed loop as g grows</source>
        <translation>Pole des geschlossenen Kreises mit wachsendem g</translation>
    </message>
    <message>
        <source>Noise (mA)</source>
        <translation>Rauschen (mA)</translation>
    </message>
    <message>
        <source>The current&apos;s noise with these gains, were the board&apos;s speed observer slower or faster (rad/s); dashed: 2 % of the current limit</source>
        <translation>Das Rauschen des Stroms mit diesen Verstärkungen, wäre der Geschwindigkeitsbeobachter des Boards langsamer oder schneller (rad/s); gestrichelt: 2 % der Stromgrenze</translation>
    </message>
    <message>
        <source>Apply 1 edit</source>
        <translation>1 Änderung übernehmen</translation>
    </message>
    <message>
        <source>Apply %1 edits</source>
        <translation>%1 Änderungen übernehmen</translation>
    </message>
    <message>
        <source>Send all edits to the board, those in Parameters too; what it accepts is shown</source>
        <translation>Alle Änderungen ans Board senden, auch die unter Parameter; was es annimmt, wird gezeigt</translation>
    </message>
    <message>
        <source>Nothing is edited: the board has what is shown</source>
        <translation>Nichts ist geändert: das Board hat, was gezeigt wird</translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>There is no edit to take back</source>
        <translation>Es gibt keine Änderung zurückzunehmen</translation>
    </message>
    <message>
        <source>Make the edit again that was taken back</source>
        <translation>Die zurückgenommene Änderung wieder machen</translation>
    </message>
    <message>
        <source>No edit was taken back</source>
        <translation>Keine Änderung wurde zurückgenommen</translation>
    </message>
    <message>
        <source>Back to what the board has</source>
        <translation>Zurück zu dem, was das Board hat</translation>
    </message>
    <message>
        <source>Nothing is edited</source>
        <translation>Nichts ist geändert</translation>
    </message>
    <message>
        <source>Automatically</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Sets gains whose margins hold for what is known of the motor; Apply sends them</source>
        <translation>Setzt Verstärkungen, deren Reserven für das gelten, was vom Motor bekannt ist; Übernehmen sendet sie</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 gemessen</translation>
    </message>
    <message>
        <source>%1 not applied</source>
        <translation>%1 nicht übernommen</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>no board</source>
        <translation>kein Board</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>%1 mA</source>
        <translation>%1 mA</translation>
    </message>
    <message>
        <source>Unstable: the loop would swing up by itself. Lower the gain or the cutoff.</source>
        <translation>Instabil: der Kreis würde sich aufschaukeln. Verstärkung oder Grenzfrequenz senken.</translation>
    </message>
    <message>
        <source>αgT is beyond its rule of thumb; g up to %1 rad/s keeps it</source>
        <translation>αgT liegt über seiner Faustregel; g bis %1 rad/s hält sie ein</translation>
    </message>
    <message>
        <source>Foretold: rise %1 ms, overshoot %2 %, settling %3 ms, peak %4 A</source>
        <translation>Vorhergesagt: Anstieg %1 ms, Überschwingen %2 %, Einschwingen %3 ms, Spitze %4 A</translation>
    </message>
    <message>
        <source>Goes to the lower end of the travel, then the step forwards, measured and stopped again, with what the board has now</source>
        <translation>Fährt zum unteren Ende des Wegs, dann den Sprung vorwärts, gemessen und wieder angehalten, mit dem, was das Board jetzt hat</translation>
    </message>
    <message>
        <source>Turns up to 2 s: standstill, then the step, measured and stopped again, with what the board has now</source>
        <translation>Dreht bis zu 2 s: Stillstand, dann der Sprung, gemessen und wieder angehalten, mit dem, was das Board jetzt hat</translation>
    </message>
    <message>
        <source>No step was measured</source>
        <translation>Kein Sprung wurde gemessen</translation>
    </message>
    <message>
        <source>Automatically, by the motor&apos;s %1</source>
        <translation>Automatisch, Motor laut %1</translation>
    </message>
    <message>
        <source>Gains, margins and step of the loop that holds a speed</source>
        <translation>Verstärkungen, Reserven und Sprung des Kreises, der eine Geschwindigkeit hält</translation>
    </message>
    <message>
        <source>Position loop</source>
        <translation>Lagekreis</translation>
    </message>
    <message>
        <source>Position step</source>
        <translation>Lagesprung</translation>
    </message>
    <message>
        <source>Position (mm)</source>
        <translation>Lage (mm)</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>Winkel (°)</translation>
    </message>
    <message>
        <source>Speed (%1)</source>
        <translation>Geschwindigkeit (%1)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Gains, margins and step of the loop that holds a position</source>
        <translation>Verstärkungen, Reserven und Sprung des Kreises, der eine Lage hält</translation>
    </message>
    <message>
        <source>This board takes no position commands</source>
        <translation>Dieses Board nimmt keine Lagebefehle an</translation>
    </message>
    <message>
        <source>From where it stands to a place so far from there</source>
        <translation>Von da, wo sie steht, zu einem Ort so weit davon</translation>
    </message>
    <message>
        <source>Holds the shaft for 0.8 s, then the step, measured and let go, with what the board has now</source>
        <translation>Hält die Welle 0,8 s, dann der Sprung, gemessen und losgelassen, mit dem, was das Board jetzt hat</translation>
    </message>
    <message>
        <source>Forget all measured steps, of both loops</source>
        <translation>Alle gemessenen Sprünge vergessen, beider Kreise</translation>
    </message>
    <message>
        <source>Foretold, friction as in the last step: rise %1 ms, overshoot %2 %, settling %3 ms, peak %4 A</source>
        <translation>Modell, Reibung laut Sprung: Anstieg %1 ms, Überschw. %2 %, Einschw. %3 ms, Spitze %4 A</translation>
    </message>
    <message>
        <source>Foretold, friction by the wiring check: rise %1 ms, overshoot %2 %, settling %3 ms, peak %4 A</source>
        <translation>Modell, Reibung laut Prüfung: Anstieg %1 ms, Überschw. %2 %, Einschw. %3 ms, Spitze %4 A</translation>
    </message>
    <message>
        <source>Foretold, friction unknown: rise %1 ms, overshoot %2 %, settling %3 ms, peak %4 A</source>
        <translation>Modell, Reibung unbekannt: Anstieg %1 ms, Überschw. %2 %, Einschw. %3 ms, Spitze %4 A</translation>
    </message>
</context>
<context>
    <name>breakaway::UnfinishedRuns</name>
    <message>
        <source>The sweeps of %1 were not finished: %2 are there, and Friction goes on with them</source>
        <translation>Die Messfahrten von %1 wurden nicht beendet: %2 sind da, und die Seite Reibung setzt sie fort</translation>
    </message>
</context>
<context>
    <name>breakaway::VerdictCard</name>
    <message>
        <source>A scale or sign is wrong, so that nothing else was looked for</source>
        <translation>Ein Maßstab oder Vorzeichen ist falsch; darum wurde nach nichts anderem gesucht</translation>
    </message>
    <message>
        <source>Nothing is missing: the base model explains the recording</source>
        <translation>Nichts fehlt: das Grundmodell erklärt die Aufzeichnung</translation>
    </message>
    <message>
        <source>%1 are missing</source>
        <translation>Es fehlen: %1</translation>
    </message>
    <message>
        <source>%1: the data allow another name, too</source>
        <translation>%1: die Daten lassen auch einen anderen Namen zu</translation>
    </message>
    <message>
        <source>Something is missing that has no name in the catalogue</source>
        <translation>Es fehlt etwas, das im Katalog keinen Namen hat</translation>
    </message>
    <message>
        <source>%1, and something unnamed</source>
        <translation>%1, und etwas Unbenanntes</translation>
    </message>
    <message>
        <source>These recordings can&apos;t tell</source>
        <translation>Diese Aufzeichnungen können es nicht sagen</translation>
    </message>
    <message>
        <source>RMS error on data that the fit never saw. The line is what noise of the sensors, the unknown start of each window and the friction&apos;s own wander leave to a perfect model.</source>
        <translation>Effektivfehler auf Daten, die die Anpassung nie gesehen hat. Die Linie ist, was Sensorrauschen, der unbekannte Anfang jedes Fensters und das Schwanken der Reibung einem vollkommenen Modell übrig lassen.</translation>
    </message>
    <message>
        <source>base model</source>
        <translation>Grundmodell</translation>
    </message>
    <message>
        <source>with findings</source>
        <translation>mit Befunden</translation>
    </message>
    <message>
        <source>perfect model</source>
        <translation>vollkommen</translation>
    </message>
    <message>
        <source>Diagnosing: %1</source>
        <translation>Diagnose: %1</translation>
    </message>
    <message>
        <source>Not diagnosed yet</source>
        <translation>Noch nicht diagnostiziert</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Diagnose says which physics was left out, how big it is, and proves it on unseen data</source>
        <translation>Die Diagnose sagt, welche Physik ausgelassen wurde und wie groß sie ist, und beweist es auf ungesehenen Daten</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>−%1 %</source>
        <translation>−%1 %</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>RMS error of the base model with %1</source>
        <translation>Effektivfehler des Grundmodells: %1</translation>
    </message>
    <message>
        <source>RMS error on %1 in windows of %2 s; it falls by %3 to %4 % (95 % interval)</source>
        <translation>Effektivfehler auf %1 in Fenstern von %2 s; er fällt um %3 bis %4 % (95-%-Intervall)</translation>
    </message>
    <message>
        <source>the held-out recording</source>
        <translation>der zurückgehaltenen Aufzeichnung</translation>
    </message>
    <message>
        <source>unseen parts</source>
        <translation>ungesehenen Teilen</translation>
    </message>
</context>
<context>
    <name>breakaway::WelcomeCard</name>
    <message>
        <source>What this bench answers</source>
        <translation>Was dieser Prüfstand beantwortet</translation>
    </message>
    <message>
        <source>Each can be tried at once, without a motor: simulated boards do all that real ones do. Nothing moves before you ask for it.</source>
        <translation>Alles lässt sich sofort und ohne Motor ausprobieren: Simulierte Boards können alles, was echte können. Nichts bewegt sich ungefragt.</translation>
    </message>
    <message>
        <source>How much friction, and where around the turn</source>
        <translation>Wie viel Reibung, und wo auf der Umdrehung</translation>
    </message>
    <message>
        <source>The torque that breaks the rotor away at every angle, both ways, over last month&apos;s map: as CSV, C header, figure or report.</source>
        <translation>Das Moment, das den Rotor losreißt, bei jedem Winkel und in beiden Richtungen, über der Karte vom letzten Monat: als CSV, C-Header, Bild oder Bericht.</translation>
    </message>
    <message>
        <source>Try Friction</source>
        <translation>Reibung ausprobieren</translation>
    </message>
    <message>
        <source>Connects the simulated servo and opens Friction; nothing moves yet</source>
        <translation>Verbindet den simulierten Servo und öffnet Reibung; noch bewegt sich nichts</translation>
    </message>
    <message>
        <source>How the loop will answer, before it moves</source>
        <translation>Wie der Regelkreis antworten wird, bevor er sich bewegt</translation>
    </message>
    <message>
        <source>Gains move a foretold step, Bode plot and poles; the step that is measured then lies over it.</source>
        <translation>Verstärkungen bewegen den Sprung des Modells, Bode-Diagramm und Pole; der gemessene Sprung liegt dann darüber.</translation>
    </message>
    <message>
        <source>Try Tune</source>
        <translation>Einstellen ausprobieren</translation>
    </message>
    <message>
        <source>Connects the simulated servo and opens Tune; nothing moves yet</source>
        <translation>Verbindet den simulierten Servo und öffnet Einstellen; noch bewegt sich nichts</translation>
    </message>
    <message>
        <source>What a simulation of the motor leaves out</source>
        <translation>Was eine Simulation des Motors auslässt</translation>
    </message>
    <message>
        <source>A recording and a bench file give a verdict in one sentence, proved on data that the fit never saw.</source>
        <translation>Aus Aufnahme und Prüfstandsdatei wird ein Urteil in einem Satz, belegt an Daten, die die Anpassung nie gesehen hat.</translation>
    </message>
    <message>
        <source>Try Compare</source>
        <translation>Vergleichen ausprobieren</translation>
    </message>
    <message>
        <source>Opens Compare, which needs no board: Example there is a recording to begin with</source>
        <translation>Öffnet Vergleichen, wofür kein Board nötig ist: Beispiel ist dort eine Aufnahme für den Anfang</translation>
    </message>
</context>
<context>
    <name>breakaway::WindowContents</name>
    <message>
        <source>Ctrl+%1</source>
        <translation>Strg+%1</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>The board&apos;s settings beside the page: compare, edit, apply (Ctrl+P)</source>
        <translation>Die Einstellungen des Boards neben der Seite: vergleichen, ändern, übernehmen (Strg+P)</translation>
    </message>
    <message>
        <source>Parameters: %1 edited</source>
        <translation>Parameter: %1 neu</translation>
    </message>
    <message>
        <source>Manual (F1)</source>
        <translation>Handbuch (F1)</translation>
    </message>
    <message>
        <source>The manual on this page; F1 on what is under the cursor</source>
        <translation>Das Handbuch zu dieser Seite; F1 zu dem, was unter dem Mauszeiger ist</translation>
    </message>
    <message>
        <source>next</source>
        <translation>als Nächstes</translation>
    </message>
</context>
</TS>
