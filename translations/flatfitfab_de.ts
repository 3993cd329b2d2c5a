<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n Teil als eines</numerusform>
            <numerusform>%n Teile als eines</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (Teil %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>nach hinten</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>in Richtung des Pfeils</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Es gibt noch keine Scheibe, also auch keine Schritte.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>Aus diesem Modell wird nichts geschnitten, also gibt es keine Schritte.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>Keine Schritte zu zeigen: das Modell lässt sich nicht zusammenbauen, weil sich %n Scheibe sperrt.</numerusform>
            <numerusform>Keine Schritte zu zeigen: das Modell lässt sich nicht zusammenbauen, weil sich %n Scheiben gegenseitig sperren.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>Keine Schritte zu zeigen: das Modell lässt sich nicht zusammenbauen, weil sich Teile von %1 gegenseitig sperren.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>Keine Schritte zu zeigen: das Modell lässt sich nicht zusammenbauen, weil sich %1 gegenseitig sperren.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>%1 um die Ecke hineinbringen, dann %2 in %3 schieben</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>%1 %2 in %3 schieben</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (seit Schritt %2 beisammen)</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Keine Schritte: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>Keine Schritte zu zeigen: die Reihenfolge des Zusammenbaus wurde in der Zeit nicht gefunden.</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>mit %1 beginnen</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>daneben mit %1 beginnen</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>%1 an seinen Platz legen</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>%1 um die Ecke hineinbringen, zuletzt %2</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>%1 %2 an seinen Platz bringen</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Zusammenhängend. Alle %1 Scheiben, durch %2.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 Verbindung</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n Verbindung</numerusform>
            <numerusform>%n Verbindungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 ist nicht mit dem Rest verbunden.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 sind nicht mit dem Rest verbunden.</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Fällt nach vorn um. Der Schwerpunkt liegt %1 vor den Füßen.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Fällt nach hinten um. Der Schwerpunkt liegt %1 hinter den Füßen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Steht. Kippt erst über %1. Reserve %2.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Fällt um. Alle Füße stehen auf einer Linie, nichts hält es aufrecht.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>Nicht auf dem Boden. Der tiefste Punkt liegt %1 darüber.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%1 Teile von %2 passen auf keine Platte von %3 mit %4 Rand, wie man sie auch dreht.</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 misst %2 und passt auf keine Platte von %3 mit %4 Rand, wie man es auch dreht.</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 Platte</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n Platte</numerusform>
            <numerusform>%n Platten</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Passt auf die Platte. %1, %2 % genutzt.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Passt auf die Platte. %1 von %2, %3 % genutzt.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>Die Schlitze lassen von %1 nichts übrig.</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Zusammenhängend</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht zusammenhängend</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Steht</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Kippt leicht</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Fällt um</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>Nicht auf dem Boden</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Passt auf die Platte</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>Zu groß für die Platte</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Von Schlitzen zerteilt</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>Nichts übrig</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Masse %1. Der Schwerpunkt liegt %2 über dem Boden.</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>weniger als %1</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Lässt sich zusammenbauen. %n Schritt.</numerusform>
            <numerusform>Lässt sich zusammenbauen. %n Schritte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Keine Reihenfolge gefunden. Die Suche dauerte zu lange; über das Modell sagt das nichts.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>Scheiben blockieren sich gegenseitig. %1 treffen sich in %2, die in %3 verschiedene Richtungen gleiten.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Baubar</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>Nicht baubar</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Reihenfolge offen</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: die Schlitze für %2 laufen ineinander.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Schlitze laufen ineinander</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>Schlitz %1 ist schmaler als das Werkzeug mit %2. Dem Material mehr Spiel der Schlitze geben oder ein dünneres Werkzeug wählen.</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Schlitz schmaler als das Werkzeug</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Kein Schlitz lässt sie zusammengleiten: Das negative Spiel lässt ihm keine Breite. Ein größeres Spiel hilft.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Kein Schlitz lässt sie zusammengleiten: Keine von beiden erreicht den Rand. Ein Loch nach außen öffnen, oder eine hindurchgehen lassen.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Nichts würde sie halten: Wo Schlitze beginnen würden, sind Löcher. Kleinere Löcher helfen, oder eine von beiden in der anderen enden lassen.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>Der tiefste Punkt von %1 liegt %2 über dem Boden.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>Die tiefsten Punkte von %1 liegen bis zu %2 über dem Boden.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>%1 konnte nicht ausgeschnitten werden: was die Schlitze davon übrig lassen, ließ sich nicht berechnen. Nichts kann exportiert werden; die Masse zählt ohne Schlitze.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ließ sich nicht berechnen: Scheiben davon fehlen. Nichts kann exportiert werden.</translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Reihenfolge nicht gefunden: %1.</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Nicht ausgeschnitten</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>Operation gescheitert</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>Schlitz %1 wird von der Schnittfuge von %2 geschlossen. Den Schlitzen des Materials mehr Spiel geben oder eine schmalere Schnittfuge.</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Nicht ermittelt</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Alle löschen</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mit %1 verbinden</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Mit %1 verbinden</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zu %1 verschieben</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Alle zu %1 verschieben</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 kürzen</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Mit Zapfen verbinden</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Spiel einstellen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Die Kopie für einen Bericht zeigen</translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Schritte zeigen</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Baubar machen</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Andere Platte wählen</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Bis zum Boden verlängern</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 bis zum Boden verlängern</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Auf den Boden setzen</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Standfläche verbreitern</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Fuß hinzufügen</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Eine Scheibe quer durch beide zeichnen oder die eine an die andere rücken.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 hält %2 nicht: Der Schlitz läuft am Rand entlang und hat nur auf einer Seite Material.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 hält %2 nicht: Die Schlitze schneiden dort ganz durch.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 hält %2 nicht: Der Schlitz ist keine %3 tief.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 hält %2 nicht: Andere Schlitze nehmen weg, was in diesem Schlitz stecken würde.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>Schlitz hält nichts</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Lose Teile</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Eine der Scheiben, die sich dort kreuzen, vor den anderen enden lassen oder beiseite rücken.</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 vom Rand hereinrücken</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 wegrücken</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>Schlitze sind %1 schmaler als das, was hineinkommt. Das ist für jedes Material zu eng.</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Schlitze zu eng</translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Berühren sich nur</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 auf 90° drehen</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Schlitze schneiden von %1 %n Splitter unter 1 mm² ab. Er ist Abfall und bekommt keine Nummer.</numerusform>
            <numerusform>Schlitze schneiden von %1 %n Splitter unter 1 mm² ab. Sie sind Abfall und bekommen keine Nummern.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>Die Schlitze von %1 teilen die Scheibe in %2, die von anderen Scheiben gehalten werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n Scheibe verschoben</numerusform>
            <numerusform>%n Scheiben verschoben</numerusform>
        </translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Die Scheibe dort breiter machen oder den Schlitz versetzen.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 hält %2 nicht: Der Schlitz lässt auf keiner Seite Material stehen.</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Schlitze zu weit</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Schlitze schneiden von %1 einen Splitter unter 1 mm² ab. Er ist Abfall und bekommt keine Nummer.</translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 um %2 verschoben</translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 hinzugefügt</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n Scheibe hinzugefügt</numerusform>
            <numerusform>%n Scheiben hinzugefügt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 gelöscht</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n Scheibe gelöscht</numerusform>
            <numerusform>%n Scheiben gelöscht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n Problem gelöst</numerusform>
            <numerusform>%n Probleme gelöst</numerusform>
        </translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Fest genug</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Hält %1</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Kaum fest genug</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Hält %1 nur knapp</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Bricht</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Zu schwach</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Bricht unter %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Zu schwach für %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 kann %2 ab %3 reißen;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>seine engste Stelle bricht bei %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>die engste Stelle von %1 bricht bei %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 kann %2 ab %3 reißen.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>Das ist weniger Reserve als der Sicherheitsfaktor %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Festigkeit unbekannt. Für das Material von %1 ist keine Festigkeit eingetragen.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Festigkeit unbekannt. Die Kräfte zwischen den Scheiben konnten nicht ermittelt werden.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Festigkeit unbekannt. Die Spannung in %1 konnte nicht ermittelt werden.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Festigkeit unbekannt</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Löst sich</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Auseinandergezogen</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Kleb sie.</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Neben dem Material</translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>neben dem Schlitz für %1</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>an einer inneren Ecke</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>an der engsten Stelle</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Dickeres Material nehmen</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>Die Schlitze von %n Verbindung treffen sich anderswo</numerusform>
            <numerusform>Die Schlitze von %n Verbindungen treffen sich anderswo</numerusform>
        </translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Seine Festigkeit eintragen</translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1-mal so viel</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Umgestoßen. Ohne den Druck stünde es.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Umgestoßen</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Ihm mehr Standfläche oder Gewicht geben, oder weniger oder tiefer unten drücken.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Biegt sich um %1.</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Dort breiter machen</translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>dann: %1</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Noch nicht verbunden</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Zwischen ihren Noppen sind Schlitze um %1 schmaler als das, was hineinkommt. Das ist für jedes Material zu stramm: die Noppen kleiner machen.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Steht noch nicht</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Noch nicht auf dem Boden</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Zu wenig Material. %1 ist an einer Stelle nur %2 breit.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Zerfällt</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Zu wenig Material</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Dort breiter machen.</translation>
    </message>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Trägt hier noch %1, dann reißt %2 %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Trägt hier %1, dann reißt %2 %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Trägt hier noch %1, dann kippt es um.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Trägt hier %1, dann kippt es um.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Trägt hier noch %1, dann wird eine Verbindung auseinandergezogen.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Trägt hier %1, dann wird eine Verbindung auseinandergezogen.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Trägt hier mehr als %1.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>Was es hier trägt, ließ sich nicht ermitteln.</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Zusammenhängend. Bisher nur eine Scheibe.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Nichts berührt %1. Von %3 ist es %2 entfernt.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Sonst berührt nichts %1. Von %3 sind sie %2 entfernt.</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>Ihre Verbindung ist auf „Keine“ gestellt.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Keine Schlitze lassen sie zusammengleiten: An der einen Stelle könnten sie nur in eine Richtung gleiten, an der anderen nur in die andere. Eine von beiden zu kürzen hilft.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 und %2 schneiden sich auf %3 Länge. %4</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 und %2 durchdringen sich um %3, außerhalb ihrer Schlitze.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 und %2 durchdringen sich um %3, sind aber nicht verbunden.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 und %2 liegen fast in einer Ebene: Sie treffen sich unter %3, und unter %4 kann kein Schlitz sie halten.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 und %2 treffen sich unter %3; unter %4 werden Schlitze breit.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Scheiben überschneiden sich</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Winkel zu flach</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Eine von beiden steiler zur anderen drehen.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Schlitze umdrehen</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Schlitz weniger tief schneiden</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>Schlitze sind %1 breiter als das, was hineinkommt; es sitzt dann locker.</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Lässt sich zusammenbauen. Bisher nur ein Teil.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>Scheiben blockieren sich gegenseitig. %1 kommt nur %2 weit aus dem Schlitz, bis es an %3 stößt.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>Scheiben blockieren sich gegenseitig. Keine von %1 lässt sich geradlinig herausziehen.</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>1 Verbindung umgedreht.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>%n Verbindung umgedreht.</numerusform>
            <numerusform>%n Verbindungen umgedreht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Eine davon kürzen oder so drehen, dass sie in derselben Richtung gleitet wie die anderen.</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Auf den Boden anheben</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Dem Modell noch einen Fuß geben oder Gewicht über die vorhandenen rücken.</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>was darauf wirkt</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Ab %1 wird eine Verbindung auseinandergezogen.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Ab %1 steht es nicht mehr.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Es trüge weit mehr.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>Wie viel es trüge, konnte nicht ermittelt werden.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>Nichts beansprucht es.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>Am schwächsten ist %1, %2: %3 % ihrer Festigkeit.</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>Die engste Stelle von %1 ist zu %2 % ihrer Festigkeit beansprucht.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Neben dem Material. Ein Gewicht auf %1 liegt über keinem Material; die nächste Stelle trägt es.</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>Die Schlitze umdrehen</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Dickeres Material nehmen, es dort breiter machen oder weniger daraufstellen.</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Zerfällt. %1 hängt an weniger zusammen, als sich schneiden lässt.</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Dort breiter machen, oder auseinanderrücken, was sich berührt.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: Zwischen den Schlitzen für %3 bleiben nur %2 Material.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: Zwischen dem Schlitz für %3 und einem Loch bleiben nur %2 Material.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: Zwischen dem Schlitz für %3 und dem Rand bleiben nur %2 Material.</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 und %2 berühren sich nur, um weniger als %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n Paar Scheiben berührt sich nur, um weniger als %1.</numerusform>
            <numerusform>%n Paare von Scheiben berühren sich nur, um weniger als %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>1 Verbindung umgedreht</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>%n Verbindung umgedreht</numerusform>
            <numerusform>%n Verbindungen umgedreht</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 dann %2 dick</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>Die Schlitze einer Verbindung treffen sich anderswo</translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 mit anderem Umriss</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>%n Scheibe mit anderem Umriss</numerusform>
            <numerusform>%n Scheiben mit anderem Umriss</numerusform>
        </translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>ein Problem gelöst</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 bricht %2 ab %3.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Lässt sich zusammenbauen. Aber nichts hält eines der Teile.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Lässt sich zusammenbauen. Aber nichts hält %n der Teile.</numerusform>
            <numerusform>Lässt sich zusammenbauen. Aber nichts hält %n der Teile.</numerusform>
        </translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Mit einem Fuß stützen</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Kann reißen</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Kann unter %1 reißen</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Am schwächsten ist %1, %2: weniger als 1 % der Festigkeit.</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Material mit %1 Dicke nehmen</translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>nichts wird sonst durchgeschnitten</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>neu: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n neue Anmerkung</numerusform>
            <numerusform>%n neue Anmerkungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Von Reibung gehalten</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Von Reibung gehalten. An der Verbindung von %1 und %2 ziehen %3 N, die nur eine enge Passung hält.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Klappt um. Fingerzinken drehen sich wie Scharniere, und sonst hält %1 nichts: Verkleben oder mit noch einer Scheibe verbinden.</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Klappt um</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>am Übergang zu %1</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>wenn es nicht umklappte</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>wenn es nicht wegrutschte</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>wenn sich nichts löste</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>wenn keine Verbindung auseinandergezogen würde</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>wenn nichts schöbe</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Würde stehen, %1. Würde erst ab %2 kippen. Reserve %3.</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Würde stehen</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Rutscht weg. Seine Füße halten nicht gegen das, was schiebt: Schwächer schieben oder beschweren.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Löst sich. Nichts hält %1 an seinem Platz: Verbindungen verkleben oder eine hinzufügen.</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>Eine an der anderen enden lassen</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 an %2 enden lassen</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Den Schlitz vom Rand weg rücken.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Noch nicht zusammenbaubar. Es ginge, wenn zwei Scheiben sich nicht überschnitten.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Noch nicht zusammenbaubar. Es ginge, wenn %n Scheibenpaar sich nicht überschnitte.</numerusform>
            <numerusform>Noch nicht zusammenbaubar. Es ginge, wenn %n Scheibenpaare sich nicht überschnitten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Noch nicht zusammenbaubar</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Fällt beim Antippen</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Recht dünn</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 trifft %2, aber nichts hält sie zusammen.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 treffen %2, aber nichts hält sie zusammen.</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>wenn es zusammenhielte</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>Schlitze zerschneiden %1. Nichts hält das Teil von %2 mit %3.</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Wäre fest genug</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Hielte %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: zwischen den Schlitzen für %2 bleibt nichts stehen.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: zwischen dem Schlitz für %2 und einem Loch bleibt nichts stehen.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: zwischen dem Schlitz für %2 und dem Rand bleibt nichts stehen.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Fällt auf seine linke Seite. Der Schwerpunkt liegt %1 außerhalb der Füße.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Fällt auf seine rechte Seite. Der Schwerpunkt liegt %1 außerhalb der Füße.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Wäre verbunden, %1.</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Wäre verbunden</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>wenn nichts zerfiele</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>wenn die Schnittfuge keinen Schlitz verschlösse</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>wenn kein Schlitz zu eng wäre</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>wenn kein Schlitz zu weit wäre</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>Schlitze zerschneiden %1 in %2 Teile</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 besteht aus %2 Teilen</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; eines davon, %2, wird von nichts gehalten.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nichts hält sie, das größte ist %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1; %2 davon werden von nichts gehalten, das größte ist %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>Schlitze zerschneiden %1. Was abgeschnitten ist, hängt zusammen, wird aber von nichts gehalten.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>Schlitze zerschneiden %1. Was abgeschnitten ist, wird mit %2 von nichts gehalten.</translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Ließe sich zusammenbauen, %1.</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Ließe sich zusammenbauen</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Auseinandergezogen. %3 N ziehen die Verbindung von %1 und %2 auseinander.</translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Zusammenhängend. Beide Scheiben, durch %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>1 Scheibe um %1 nach unten verschoben</numerusform>
            <numerusform>%n Scheiben um %1 nach unten verschoben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>1 Scheibe um %1 nach oben verschoben</numerusform>
            <numerusform>%n Scheiben um %1 nach oben verschoben</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1 um %2 gedreht</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>1 Scheibe gedreht</numerusform>
            <numerusform>%n Scheiben gedreht</numerusform>
        </translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Steht, um %1 schief. Kippt erst ab %2. Reserve %3.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Neigt sich um %1 nach vorn</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Neigt sich um %1 nach hinten</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Neigt sich um %1 nach links</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Neigt sich um %1 nach rechts</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1, bevor es steht: Seine tiefsten Punkte liegen nicht alle auf dem Boden. Kippt erst ab %2.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>Nicht auf dem Boden. Ihr tiefster Punkt ist %1 darüber.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Verbinde es mit dem, was steht, oder schiebe es auf den Boden.</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Steht schief</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>Trägt nichts. Die Verbindung von %1 und %2 wird mit %3 N auseinandergezogen; die anderen halten ohne sie.</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>Trägt nichts</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 sind im Ring verbunden: in der Reihenfolge der Schritte zusammenbauen.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Scheiben sind in %n Ring verbunden: in der Reihenfolge der Schritte zusammenbauen.</numerusform>
            <numerusform>Scheiben sind in %n Ringen verbunden: in der Reihenfolge der Schritte zusammenbauen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>Im Ring verbunden</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Fällt bei einer Berührung: um %1 geneigt kippt es um. Reserve %2.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 sind im Ring verbunden: Welche auch zuletzt kommt, sie muss auf zwei andere zugleich geschoben werden.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Scheiben sind in %n Ring verbunden: Welche auch zuletzt kommt, sie muss auf zwei andere zugleich geschoben werden.</numerusform>
            <numerusform>Scheiben sind in %n Ringen verbunden: Welche eines Rings auch zuletzt kommt, sie muss auf zwei andere zugleich geschoben werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>eine neue Verbindung mit einem Schlitz von %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 neue Verbindung</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n neue Verbindung</numerusform>
            <numerusform>%n neue Verbindungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Steht, wackelt aber um %1. Kippt erst über %2. Reserve %3.</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Wackelt um %1: Seine tiefsten Punkte liegen nicht alle auf dem Boden. Kippt erst über %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Wackelt</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Steht kaum: um %1 geneigt kippt es um. Reserve %2.</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Lass alle Füße auf gleicher Höhe enden.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Rücke eine von ihnen beiseite oder lass sie vor der anderen enden.</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>In Ringen verbunden</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>Im Boden. %1 reicht %2 darunter.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>Im Boden. %1 reichen bis zu %2 darunter.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>Im Boden</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Ebenen um %1 % versetzen</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>Eine Ebene mehr je Richtung</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Passt auf die Platten und Reststücke, die da sind.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>Höchstens %n Platte</numerusform>
            <numerusform>Höchstens %n Platten</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Passt auf die Platte. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Passt auf die Platte. %1 von %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Scheiben überschneiden sich etwas</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>Platten können ausgehen. Es braucht bis zu %n Platte aus %1, und da sind %2.</numerusform>
            <numerusform>Platten können ausgehen. Es braucht bis zu %n Platten aus %1, und da sind %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>Platten können ausgehen</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Unter „Platten“ nachsehen, wie eng die Teile liegen können.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Ebenen alle %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, um %2 % versetzt</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>Eine Ebene mehr</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>Eine Ebene weniger je Richtung</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>Eine Ebene weniger</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>Zwei Ebenen mehr je Richtung</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>Zwei Ebenen mehr</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>Zwei Ebenen weniger je Richtung</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>Zwei Ebenen weniger</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Keine Verschiebung und keine Zahl der Ebenen, die versucht wurde, lässt sie ineinandergleiten. Die Schnitte umwandeln und eine davon kürzen oder weglassen.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>&amp;Modell einfügen …</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>Die Scheiben eines anderen Modells zu diesem hinzufügen</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>In &amp;die Bibliothek aufnehmen</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>In Bibliothek</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Das Modell speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Das Modell unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Schneiddateien e&amp;xportieren …</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export …</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>Die Teile in eine Datei für den Laserschneider schreiben</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>&amp;Zum Gespeicherten zurück</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurückkehren</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Zum Modell zurück, wie es in der Datei steht; Rückgängig bringt die Änderungen wieder</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Einheiten, Farben, Sprache, Dateien und Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Fenster s&amp;chließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Dieses Fenster schließen; andere bleiben offen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Alle Fenster und das Programm schließen</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Zu den Eigenschaften</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>Die Leisten an den Seiten aus- oder einblenden</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Den Bildschirm mit dem Fenster füllen</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Fenster &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Fenster zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Nä&amp;chster Teil des Fensters</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Nächster Teil</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Zum nächsten Teil des Fensters: Werkzeugleiste, links, Ansicht, rechts</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Voriger Teil des Fensters</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Voriger Teil</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Zum vorigen Teil des Fensters zurück</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>&amp;Nächstes Problem</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Nächstes Problem</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>Die Scheiben des nächsten Problems wählen und zeigen</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>&amp;Voriges Problem</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Voriges Problem</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>Die Scheiben des vorigen Problems wählen</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Schritte &amp;zeigen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Schritt für Schritt zeigen, wie das Modell zusammengebaut wird</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Mate&amp;rialien …</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Plattenmaterial: Dicke, Festigkeit, Schnittfuge und Plattengröße</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Tippen, um alles zu finden, was das Programm kann</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>S&amp;tartseite</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Zuletzt benutzte Modelle und Beispiele</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>&amp;Über FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>Was dieses Programm ist, seine Version und seine Lizenzen</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Zuerst eine Scheibe auswählen</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>Keine Verbindung ist gewählt: erst eine Scheibe wählen, dann eine ihrer Verbindungen</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>Es ist keine Operation ausgewählt</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Es gibt noch keine Scheibe</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>Keine Scheibe ist gewählt</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>A&amp;usschneiden</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>Die ausgewählten Scheiben kopieren und löschen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>Die ausgewählten Scheiben kopieren, auch für andere Fenster und Programme</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>E&amp;infügen</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>Eine Kopie der ausgewählten Scheiben danebenstellen</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>An &amp;X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>An X spiegeln</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Ein Spiegelbild der ausgewählten Scheiben auf die andere Seite der Ebene stellen, in der X gleich 0 ist</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>An &amp;Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>An Y spiegeln</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Ein Spiegelbild der ausgewählten Scheiben auf die andere Seite der Ebene stellen, in der Y gleich 0 ist</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>An &amp;Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>An Z spiegeln</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Ein Spiegelbild der ausgewählten Scheiben auf die andere Seite der Ebene stellen, in der Z gleich 0 ist</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>An einer &amp;Scheibe …</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Auf eine Scheibe klicken: Ein Spiegelbild der ausgewählten kommt auf ihre andere Seite</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>Aus SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Eine Scheibe für jeden Umriss einer Zeichnung</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Kontur aus SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>Der größte Umriss einer Zeichnung anstelle dessen der gewählten Scheibe</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Löcher aus SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Ein Loch der gewählten Scheibe für jeden Umriss einer Zeichnung</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Markierungen aus SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>Die Linien einer Zeichnung, auf die gewählte Scheibe graviert oder geritzt</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Form &amp;zeichnen</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Kreis, Rechteck und dergleichen aus der Mitte aufziehen</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>&amp;Kreis</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>Mit Zahlen: ein Loch in der ausgewählten Scheibe oder eine eigene Scheibe</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>&amp;Vieleck</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>&amp;Stern</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>&amp;Langloch</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Langloch</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Schl&amp;itze der Verbindung umdrehen</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Schlitze umdrehen</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>Die Schlitze der gewählten Verbindung zur anderen Seite öffnen</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>An dieser Verbindung ist nichts von Hand eingestellt</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Te&amp;xt oder Linien gravieren</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Gravieren</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Auf eine Scheibe schreiben oder zeichnen, zum Gravieren oder Ritzen</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>&amp;Gravieren</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>Was als Nächstes gezeichnet wird, wird graviert</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>&amp;Ritzen</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Ritzen</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>Was als Nächstes gezeichnet wird, wird geritzt, zum Falten oder Brechen</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>Nichts ist gemessen</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Reihe</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>Eine Scheibe in einer Reihe entlang einer anderen wiederholen</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>&amp;Umlauf entlang der Kontur</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Eine Scheibe um die Kontur einer anderen herum wiederholen</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Über&amp;gang</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>&amp;Verzweigung</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Zweige</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Ra&amp;ster mit Verbindern</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Eine Scheibe teilen, die für die Platte zu groß ist</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>Run&amp;dform</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>&amp;Modell spiegeln</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Dr&amp;ehsymmetrie</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>Scheiben entlang einer Linie durch den Raum wiederholen</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>&amp;Jetzt symmetrisch machen</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>&amp;Aus- oder einschalten</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>Die ausgewählte Operation aus- oder wieder einschalten</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>&amp;Früher in der Reihenfolge</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>S&amp;päter in der Reihenfolge</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>In Scheiben um&amp;wandeln</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Umwandeln</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>Schon die erste</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>Schon die letzte</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Einr&amp;asten</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Fang</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Fe&amp;der</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>Es ist keine Zahl eingegeben</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Löche&amp;r entfernen</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Keine Löcher</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Alle Löcher der gewählten Scheiben schließen</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Punkt &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt dazu</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Einen Kontrollpunkt unter dem Zeiger oder neben dem gewählten hinzufügen</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Punkt lös&amp;chen</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Punkt löschen</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>Die gewählten Kontrollpunkte löschen</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Punkt &amp;glätten</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>S&amp;ymmetrischer Punkt</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Eckp&amp;unkt</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Die gewählten Punkte zu Ecken machen</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>Kein Punkt einer Kontur ist ausgewählt</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Zuerst eine Scheibe auswählen, deren Kontur sich ändern lässt</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Bewe&amp;gen und drehen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Mit Griffen oder Zahlen bewegen, drehen und skalieren</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Auf eine andere S&amp;cheibe setzen …</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Aufsetzen</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Rec&amp;htwinklig stellen</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Rechtwinklig</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>An nächster Achse ausrichten</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>S&amp;perren</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>&amp;Quelle bearbeiten</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Quelle bearbeiten</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>Die Scheibe auswählen, aus der die ausgewählte gemacht wird</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>Diese &amp;lösen</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>Diese auslassen</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles wählen</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles wählen</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Alle Scheiben wählen</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Näc&amp;hste wählen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>Die nächste Scheibe wählen</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Vori&amp;ge wählen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>Die Scheibe davor wählen</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>&amp;Verbundene auswählen</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbundene</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>&amp;Parallele auswählen</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Alle Scheiben auswählen, die parallel zu den ausgewählten sind</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Gleiche Platte</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Ein neues Modell beginnen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>Die gewählten Scheiben löschen</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Punkt setzen</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>„%1“ &amp;rückgängig machen</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>„%1“ &amp;wiederholen</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Lokale &amp;Symmetrie</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Eine Kontur an ihrem Schlitz spiegeln, wenn sie auf einer Seite davon gezeichnet wird</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Am &amp;Boden eben abschneiden</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Abschneiden, was unter dem Boden gezeichnet wird</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>Auf dem B&amp;oden</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Am Boden</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Eine Scheibe zeichnen, die auf dem Boden liegt</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>Auf der &amp;Vorderebene</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Eine Scheibe aufrecht in der Mitte zeichnen, von vorn gesehen</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>Auf der S&amp;eitenebene</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Seitlich</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Eine Scheibe aufrecht in der Mitte zeichnen, von der Seite gesehen</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>&amp;Parallel zur Scheibe</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Eine Scheibe parallel zur ausgewählten zeichnen</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Kontur &amp;neu zeichnen</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Für die ausgewählte Scheibe eine neue Kontur zeichnen</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>&amp;Loch zeichnen</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>In die ausgewählte Scheibe ein Loch zeichnen</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Auf den Boden se&amp;tzen</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Absetzen</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Das Modell auf den Boden setzen</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Von vorn ansehen</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Von oben ansehen</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Von rechts ansehen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Von hinten ansehen</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Von unten ansehen</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Von links ansehen</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Nächste &amp;Ecke</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Von der nächsten Ecke ansehen</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Auf die &amp;Scheibe sehen</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Draufsicht</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Gerade auf die gewählte Scheibe sehen</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Alles ein&amp;passen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Das ganze Modell zeigen</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Auswahl einpasse&amp;n</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Auswahl einpassen</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>Die gewählten Scheiben so groß wie möglich zeigen</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Vori&amp;ge Ansicht</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Zur vorigen Ansicht zurück</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspe&amp;ktive</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>Entferntes kleiner zeigen, wie das Auge es sieht</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Rön&amp;tgenblick</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Durch alle Scheiben sehen, bis auf die Schlitze</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Nur die Aus&amp;wahl</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Nur Auswahl</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ausblenden</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>Die gewählten Scheiben ausblenden</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Alle einblen&amp;den</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>Die ausgeblendeten Scheiben wieder zeigen</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Ansicht au&amp;fschneiden</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Das Modell mit einer Ebene aufschneiden, um hineinzusehen</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>&amp;Boden und Schatten</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>Den Boden mit Raster und den Schatten des Modells zeigen</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>Keine Scheibe ist ausgeblendet</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>Vor dieser Ansicht gab es keine</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>Es gibt keine andere Scheibe</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>Für das eben Gezeichnete wird nichts angeboten</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Spannungs&amp;linien</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Zeigt, wo das Modell am stärksten beansprucht ist</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>&amp;Gewicht setzen</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>&amp;Hier ziehen</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Auf das Modell wirkt nichts: zuerst ein Gewicht oder einen Druck hinzufügen</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>&amp;Druck hinzufügen</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Noch&amp;mals exportieren</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Nochmals exportieren</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Dieselbe Datei noch einmal schreiben, mit denselben Angaben</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Wie ein Modell entsteht, Schritt für Schritt, mit Bildern</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Scheiben aus SV&amp;G …</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>&amp;Kontur aus SVG …</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>&amp;Löcher aus SVG …</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>&amp;Markierungen aus SVG …</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>Zwischen zwei Stellen messen; die Länge behalten oder das Modell danach skalieren</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Auf &amp;Länge skalieren</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Auf Länge skalieren</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Eine Länge festlegen und das Modell danach skalieren</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>&amp;Spiegeln …</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>Die gewählten Scheiben spiegeln oder eine Seite des Modells auf die andere</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Links und rechts spiegeln (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>An der Ebene spiegeln, in der X 0 ist</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Oben und unten spiegeln (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>An der Ebene spiegeln, in der Y 0 ist</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Vorn und hinten spiegeln (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>An der Ebene spiegeln, in der Z 0 ist</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>An einer Scheibe spiegeln</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>An der Ebene der Scheibe spiegeln, die angeklickt wird</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Gespiegelte Kopie der Auswahl</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Ein Spiegelbild der gewählten Scheiben hinzufügen</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Beide Seiten gleich halten</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide Seiten</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Einmal symmetrisch machen</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Einmal</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Wie gezeigt spiegeln</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Ausführen, was zu sehen ist</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Zuerst Spiegeln wählen</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Ein Modell öffnen, auch eines von FlatFab</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>Die Auswahl für andere Modelle in der Bibliothek aufheben</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Zum ersten Feld dessen, was gewählt ist; in der Ansicht tut das Eingabe</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Alle Leisten dorthin setzen, wo sie anfangs waren</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Befehl &amp;suchen …</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Es wurde noch nicht exportiert</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Es wurde nie gespeichert</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Seit dem Speichern wurde nichts geändert</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Fes&amp;tigkeitskarte</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Festigkeitskarte</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Eine Scheibe danach färben, welche Masse sie an jeder Stelle trägt</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Zuerst die Scheibe auswählen, von der gezeigt werden soll, was sie trägt</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Automatik &amp;wiederherstellen</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Wieder automatisch</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Art, Richtung und Treffpunkte der gewählten Verbindung wieder dem Programm überlassen</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Ein Gewicht auf eine Scheibe setzen, um zu sehen, was sie trägt</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>An einer Stelle einer Scheibe drücken oder ziehen, um zu sehen, was sie trägt</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Mit der Maus an einer Scheibe ziehen und sehen, was geschieht; nichts bleibt</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Länge &amp;behalten</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Diese Länge weiter anzeigen</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Dieses Maß ent&amp;fernen</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Dieses Maß entfernen</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>Kein Maß ist gewählt: eines mit „Messen“ anklicken</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Alles spiegeln, was auf einer Seite gezeichnet ist, auch künftig</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>Was auf einer Seite steht, auf die andere kopieren; spätere Änderungen nicht</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>An&amp;gebotenes übernehmen</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Aus dem eben ungefähr so Gezeichneten einen Kreis, eine Ellipse, gerade Linien oder rechte Winkel machen, oder seinen Schlitz vom Rand hereinrücken</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Übergänge zwischen Scheiben bilden</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Eine Scheibe immer wieder aus sich selbst wachsen lassen, wie einen Baum</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>Eine Scheibe zu Kreis, Stern oder Zahnrad machen oder solche Löcher hineinsetzen</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Was auf einer Seite gezeichnet ist, auch auf der anderen stehen lassen</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Was einmal gezeichnet ist, rings um eine Achse stehen lassen</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>Eine Seite einmal auf die andere spiegeln</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>Die ausgewählte Operation vor der darüber arbeiten lassen</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>Die ausgewählte Operation nach der darunter arbeiten lassen</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Aus dem, was die ausgewählte Operation macht, gezeichnete Scheiben machen</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>An Punkten, Hilfslinien und Raster einrasten</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Mit Klicks statt in einem Zug zeichnen: Punkte setzen, zum Biegen ziehen</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>Die Kontur glatt durch die gewählten Punkte führen</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>Die Kontur glatt machen, mit gleich langen Griffen zu beiden Seiten</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>Die Auswahl hat keine Löcher</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>&amp;Entlang der Weltachsen</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Weltachsen</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Entlang der Achsen der Welt bewegen, nicht in der Ebene der Scheibe</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Anhängende Scheiben &amp;mitbewegen</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Mitbewegen</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Scheiben, die auf dieser gezeichnet sind, bewegen sich mit</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Die Scheibe anklicken, auf die die ausgewählte gesetzt werden soll</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Von der &amp;übergeordneten lösen</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Von der übergeordneten lösen: Sie bewegt sich nicht mehr mit und behält ihren Winkel nicht</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>Die Scheibe rechtwinklig zu der stellen, auf der sie sitzt</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>Die Scheibe so drehen, dass sie entlang einer Achse der Welt schaut</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>Die ausgewählten Scheiben vor Änderungen schützen</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>Aus der ausgewählten eine gezeichnete Scheibe machen; ihre Operation macht die anderen</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>Die ausgewählte Scheibe nicht machen; ihre Operation macht die anderen</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>Die Auswahl sitzt auf keiner anderen Scheibe</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>Die Auswahl macht eine Operation</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>Die Auswahl ist nicht symmetrisch</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>Die Auswahl ist gezeichnet, nicht von einer Operation gemacht</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Alle Scheiben auswählen, die mit den ausgewählten verbunden sind</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Gl&amp;eiches Material auswählen</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Alle Scheiben aus dem gleichen Material wie die ausgewählten auswählen</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Den letzten Schritt rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>Den zurückgenommenen Schritt wiederholen</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts zurückzunehmen</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nichts zu wiederholen</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>Das Modell steht auf dem Boden</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Alle anderen Scheiben blass zeigen</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>&amp;Ganze Führung übernehmen</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Führung übernehmen</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>Die Scheibe aus allem machen, was ihre Ebene aus einer Vorlage schneidet, mit den Löchern</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>Die Ebene, auf der gezeichnet wird, schneidet keine Vorlage</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>Es gibt keine Vorlage: erst ein Netz oder ein Bild hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>&amp;Schnitte eines Netzes</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Ein Netz, über dem gezeichnet wird, in Scheiben schneiden, die ihm folgen</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>Es gibt kein Netz zum Schneiden: erst eines hinzufügen</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Alle Fensterteile ausblenden</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Fenster ausblenden</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>Kein Netz da, das sich anziehen ließe</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>Es gibt kein Bild und keine Zeichnung: füge zuerst eines hinzu</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>&amp;Vorlage zum Nachzeichnen …</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Ein Netz, ein Bild oder eine Zeichnung einlesen, um darüber zu zeichnen</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>&amp;Haut</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>Die Form zeigen, die die Scheiben andeuten, als Fläche darüber</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>Kopierte Scheiben einfügen, oder ein Bild zum Nachzeichnen</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Vo&amp;rlage bewegen</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Die Vorlage mit Griffen oder Zahlen bewegen, drehen und skalieren</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Vorlage nach einer &amp;Linie skalieren</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Nach einer Linie</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Eine Linie über die Vorlage ziehen und sagen, wie lang sie ist</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>&amp;Platten</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Platten</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>Die Teile auf ihren Platten zeigen, wie sie geschnitten werden</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Alle lösen</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Alle Teile dürfen wieder bewegt werden, wenn sie auf Platten gelegt werden</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>Kein Teil ist auf seiner Platte angeheftet</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Alle Teile &amp;lösen</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>&amp;Tastenkürzel…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Sieh nach, welche Tasten was tun, und wähle eigene</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Pass&amp;probe …</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Passprobe</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Ein Teststück schreiben, das zeigt, welche Schlitze passen und wie breit die Maschine schneidet</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Zu den Werten</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>Die Werte einstellen, aus denen Zahlen des Modells entstehen</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Neuer Wert</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Eine Zahl mit einem Namen, den Zahlenfelder annehmen</translation>
    </message>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>Das Modell ist zum Anpassen da; „Entwurf bearbeiten“ holt alles zurück</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Zum Anpassen weitergeben</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Weitergeben</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Wer das gespeicherte Modell öffnet, sieht die Ansicht, die gezeigten Werte und den Export, sonst nichts</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Entwurf bearbeiten</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Andere können noch keinen Wert anpassen</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>Das einfache Fenster kommt ohne das aus; in den Einstellungen gibt es das ganze</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Dein erstes Modell in 3 &amp;Minuten</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Schritt für Schritt ein Modell zeichnen, prüfen und ausschneiden, in einem leeren Fenster</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Hilfe zu dem, was unter dem Zeiger ist</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Öffnet die Hilfe dort, wo sie von diesem Teil des Fensters erzählt</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>Nicht spiegeln</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Alles lassen, wie es war</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Scheiben, Verbindungen, Größe und Masse eines Modells</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>„%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Ein Bild des Modells; braucht eine Anzeige</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Ob es zusammenhält, steht, sich zusammenbauen lässt und auf die Platte passt</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Wie es zusammengebaut wird, Schritt für Schritt; braucht eine Anzeige</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>das Modell selbst</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>die Körper an ihrem Ort</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>Schneiddateien in wahrer Größe</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>Zu groß für die Platte, auf eigenen Platten: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Zu schmal für eine Nummer: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Ein Loch oder eine Kerbe, schmaler als die Schnittfuge, wird nicht geschnitten: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>Kein Platz für die Nummern aller Verbindungen: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>Die Standardausgabe ließ sich nicht schreiben.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Gibt JSON aus, für andere Programme.</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Ob es hält: Kräfte, Spannungen und was es trägt</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>Was zu schneiden ist, in den eigenen Koordinaten jeder Scheibe</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Die Operationen, die es gibt, oder die eines Modells</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Spielt ein Skript dessen ab, was jemand tut</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Die Schlitze lassen von diesen nichts übrig, sie haben also kein Teil: %1</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>Nichts zu prüfen: Das Modell hat keine Scheibe.</translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>Scheiben biegen sich, wo sich Verbindungen eine Last teilen: finite Elemente für jede; dauert Sekunden.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>Was wirkt, bleibt Monate: Jedes Material trägt den Anteil, den es angibt.</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Millimeter je Einheit einer FlatFab-Datei (25.4).</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>Die Umrisse, in denen eine Ebene ein Netz schneidet</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Scheiben, die ein Netz zeigen, stehen und sich zusammenbauen lassen</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Ein Modell aus Schnitten eines Netzes</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Ein Modell aus flachen Platten mit Fingerzinken an den Kanten</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF mit Ebenen nach Zweck</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Fassung einer DXF-Datei: r2000 oder r12 (r2000).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-Code für Laser</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>ein LightBurn-Projekt</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>die Stückliste</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF in Originalgröße</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Seiten einer PDF-Datei: sheet (je Platte eine), oder verteilt auf a4 oder letter (sheet).</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Wie Teile in einer STL- oder 3MF-Datei liegen: in-place (an ihrem Platz) oder flat (flach auf ihren Platten) (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>die Teile zum Drucken</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>ein Bild der Platten</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>alles für eine Werkstatt</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Teile dicht beieinander auf Platten, oder die Stücke eines Streifens (.json)</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>Die benannten Werte eines Modells und was daraus gemacht ist</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Eine Schneiddatei und ein Urteil für jede Zeile einer Tabelle von Werten</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>es gibt keine Anzeige mit OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>Die Suche wurde vor ihrem Ende abgebrochen, weil dieser Rechner ausgelastet ist: Ein anderer Lauf kann anders anordnen.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Schlitze zum Probieren</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Streifen zum Hineinstecken</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Leiste zum Messen</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Zu nah am Rand: Der Schlitz hielte nichts</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Zu nah am Rand: Der Schlitz hielte nichts. B: hereinrücken</translation>
    </message>
    <message>
        <source>level</source>
        <translation>waagrecht</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>rechtwinklig zum Rand</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>parallel zum letzten</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Noch nicht verbunden</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Um %1 hereingerückt. B: zurücknehmen</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Dreht sich …</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Jetzt die Kontur zeichnen</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>„%1“ ist %2, was hier nicht möglich ist.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>„%1“ und ein anderer Ausdruck wollen dies zugleich verschieden.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Wozu diese Zahl gehört, gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>X der Mitte</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>Y der Mitte</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>Höhe der Buchstaben</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittbreite</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Breite einer Platte</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Höhe einer Platte</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Durchmesser des Werkzeugs</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Einführfase der Schlitze</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Noppen in Schlitzen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Gefüllt mit</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Kraft entlang X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Kraft entlang Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Kraft quer dazu</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Treffpunkt</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>„%1“ ist hier nicht möglich: Zahlen, die Werten folgen, halten es bei %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>„%1“ ist hier nicht möglich: %2 folgt „%3“, und das hält es, wie es ist.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>„%1“ lässt sich nicht ausrechnen.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>„%1“ ist leer, das geht hier nicht.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>a model</source>
        <translation>ein Modell</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>gefunden: „%1“, erwartet: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>gefunden: Anzahl %1, erwartet: höchstens %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>gefunden: %1 %3, erwartet: höchstens %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>mit einem neueren FlatFitFab gemacht</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>mit einem neueren FlatFitFab gemacht: Format %1, dieses liest bis %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>die Datei endet hier, erwartet: %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>gefunden: „%1“, erwartet: eine endliche Zahl</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>eine Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>diese Kontur umschließt keine Fläche</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>nichts hat die Nummer %1</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>diese zwei Scheiben sind fast parallel und lassen sich nicht verbinden</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>diese Kontur kreuzt sich selbst</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>es gibt noch keine Scheibe, also nichts zu schneiden</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>es gibt keinen Befehl „%1“</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>diesen Befehl gibt es nicht</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>dieses Ereignis ergibt hier keinen Sinn</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>„%1“ kennt diese Version nicht</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>das kennt diese Version nicht</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>ein Loch von %1 hat keine Fläche und wurde weggelassen</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>ein Loch hat keine Fläche und wurde weggelassen</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>Zeilen nach der letzten Scheibe wurden übergangen</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>Text nach der letzten Scheibe wurde übergangen, Zeilen: %1</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>eine Nummer unter nextId</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>eine Breite und eine Höhe über 0</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>eine Elternscheibe, die nicht von ihrem Kind abstammt</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>eine Länge von höchstens 1000000 mm</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>ein letzter Kontrollpunkt, der den ersten wiederholt</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>eine Anzahl</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>ein Punkt aus zwei Zahlen</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>mindestens 1 Kurve</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>eine ganze Zahl in ihrem Bereich</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>ein Punkt [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>ein Punkt [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>eine Liste von Punkten</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>ein Name in Anführungszeichen oder das Ende des Objekts</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>ein Doppelpunkt</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>ein Komma oder das Ende der Liste</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>eine Escape-Folge von JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>Text in UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>das Ende des Textes in Anführungszeichen</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>ein weiterer Wert nach dem Komma</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>höchstens 1024 Ebenen</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>eine kleinere Datei</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>diese Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>dieser Ordner ist schreibgeschützt</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>mindestens ein Material</translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>der Ordner ist nicht nutzbar</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>es ist in einem anderen Fenster offen</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>es blieben zu wenige Punkte, um etwas zu umschließen</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>eine Richtung der Länge 1</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>ein Anteil von 0.05 bis 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>ein Wunsch an zwei Scheiben, die Paare aufsteigend</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone oder tBone</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs oder none</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden oder detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>etwas anderes als gemacht, jede Instanz einmal</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved oder scored</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>wenigstens eine Linie</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>zwei verschiedene Orte</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>ein Wort aus Buchstaben und Ziffern, einmal</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>eine Transformation</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>Gruppen in Gruppen</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>Zahlenpaare</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>Pfaddaten</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>Orte innerhalb eines Kilometers</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>eine SVG-Zeichnung</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>Linien, Formen oder Pfade</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>das ließ sich nicht berechnen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>„%1“ konnte nicht ausgeschnitten werden: was die Schlitze davon übrig lassen, ließ sich nicht berechnen</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>eine Scheibe konnte nicht ausgeschnitten werden</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>der Körper von „%1“ ließ sich nicht berechnen</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>ein Körper ließ sich nicht berechnen</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>die Scheiben der Operation „%1“ ließen sich nicht berechnen</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>die Scheiben einer Operation ließen sich nicht berechnen</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>eine Datei braucht einen Namen</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>mehr als minus die Dicke</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>eine Zahl über 0, höchstens 1000000</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>eine Zahl von 0 bis 1000000</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>beide Hälften eines Zeichens</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>10 Sekunden lang kam nichts heraus</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>Linien; Text muss zuerst in Pfade umgewandelt werden</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>Linien; ein Bild muss zuerst nachgezeichnet werden</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>Elemente und Attribute</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>Stellen, an denen eine Linie sich kreuzen kann</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>die Schnittfuge schließt einen Schlitz</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 hat einen %2 mm breiten Schlitz, den eine Schnittfuge von %3 mm schließen würde</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>in FlatFitFab ist etwas schiefgegangen (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>in FlatFitFab ist etwas schiefgegangen</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>es wurde angehalten</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>Einträge</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>dieser Eintrag ist beschädigt</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>dieser Eintrag ist verschlüsselt</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>Einträge darin teilen sich ihre Bytes</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>eine %1-Datei</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>eine %1-Datei von %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>kein Modell, erwartet: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 konnte nicht gelesen werden und wurde weggelassen</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>ein Bild oder ein Netz wurde weggelassen</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 wurde weggelassen: %2</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>ein SHA-256 aus 64 Hexadezimalziffern</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>dieser Eintrag fehlt</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>nichts im Dokument verweist auf diesen Eintrag</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>die Schlitze lassen von keiner Scheibe etwas übrig, es gibt also nichts zu schneiden</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>jeder Schlüssel eines Objekts nur einmal</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point, patch oder edge</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point, patch, edge oder hanging</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>eine Breite von 1 bis 10000 mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>eine Kraft [x, y, z] über 0, höchstens 1000000 N</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>eine Höhe von 0 bis 10000 mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>einen Teil seiner Masse</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>ein Anteil über 0, höchstens 1</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>sein Inhaltsverzeichnis ist beschädigt</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>in der Datei steht mehr als das, was darin gepackt ist</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>diesen Eintrag gibt es zweimal</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>dieser Eintrag ist auf eine Art gepackt, die hier nicht bekannt ist</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>dieser Eintrag selbst heißt anders als in der Liste des Gepackten</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>wenige Bytes dieses Eintrags stehen für viel zu viele</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>mit gzip gepackte Daten, unbeschädigt</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>der Rest dessen, was mit gzip gepackt ist</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>dieser Wert ist hier nicht möglich</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>hier steht nichts, erwartet: %1</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>eine Anzahl, die nicht möglich ist</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>diese Kontrollpunkte ergeben keine geschlossene Kontur</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>diese Kontrollpunkte ergeben keine geschlossene Kontur: gefunden: %1, erwartet: %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>um diesen Umriss führt kein Weg überall im Abstand der halben Schnittfuge</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>um %1 führt kein Weg überall im Abstand der halben Schnittfuge von %2 mm; das Feinste an der Kontur glätten oder dem Material eine andere Schnittfuge geben</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>diese Achsen ergeben kein Koordinatensystem, erwartet: zwei der Länge 1 im rechten Winkel</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>das verweist auf etwas, das es nicht gibt</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>die Nummer %1 ist doppelt vergeben, erwartet: eine eigene</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>diese Nummer ist doppelt vergeben, erwartet: eine eigene</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>ein Loch würde den Rand oder ein anderes Loch berühren</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>was auf „%1“ gezeichnet ist, ließ sich nicht am Rand abschneiden</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>was auf einer Scheibe gezeichnet ist, ließ sich nicht am Rand abschneiden</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>der Inhalt dieser Datei ist beschädigt</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 war leicht schief und ist begradigt</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>eine Scheibe war leicht schief und ist begradigt</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>die Kontur von %1 kreuzt sich selbst; ihre größte Schleife blieb</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>eine Kontur kreuzt sich selbst; ihre größte Schleife blieb</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>ein Loch von %1 ragt aus der Kontur und wurde weggelassen</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>ein Loch ragt aus seiner Kontur und wurde weggelassen</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>Löcher von %1 überlappen sich und wurden vereint</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>Löcher überlappen sich und wurden vereint</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>ein Loch von %1 ragt aus der Kontur und wurde aus ihr ausgeschnitten</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>ein Loch ragt aus seiner Kontur und wurde aus ihr ausgeschnitten</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>drei Stützpunkte je Abschnitt und einen</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>seine Bytes fehlen</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>ein Eintrag dieses Namens hat hier nichts zu suchen</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>dieser Eintrag ist nicht, was sein Name, ein SHA-256, besagt</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>drei Kontrollpunkte je Segment, mindestens 6</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>drei Kontrollpunkte je Segment und der erste noch einmal, mindestens 7</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>niemand schreibt in diese Pipe</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>niemand liest diese Pipe</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n Scheibe war leicht schief und ist begradigt.</numerusform>
            <numerusform>%n Scheiben waren leicht schief und wurden begradigt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n Kontur kreuzte sich selbst; ihre größte Schleife blieb.</numerusform>
            <numerusform>%n Konturen kreuzten sich selbst; von jeder blieb die größte Schleife.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n Loch ragte aus seiner Kontur und wurde weggelassen.</numerusform>
            <numerusform>%n Löcher ragten aus ihren Konturen und wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n Loch hatte keine Fläche und wurde weggelassen.</numerusform>
            <numerusform>%n Löcher hatten keine Fläche und wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Löcher von %n Scheibe überlappten sich und wurden vereint.</numerusform>
            <numerusform>Löcher von %n Scheiben überlappten sich und wurden vereint.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n Loch ragte aus seiner Kontur und wurde aus ihr ausgeschnitten.</numerusform>
            <numerusform>%n Löcher ragten aus ihren Konturen und wurden aus ihnen ausgeschnitten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Text nach der letzten Scheibe wurde an %n Stelle übergangen.</numerusform>
            <numerusform>Text nach der letzten Scheibe wurde an %n Stellen übergangen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>%n Bild oder Netz ließ sich nicht lesen und wurde weggelassen.</numerusform>
            <numerusform>%n Bilder oder Netze ließen sich nicht lesen und wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>seine Bytes sind beschädigt</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh, picture oder curves</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>nichts: nur Netze werden gezogen</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>ein Radius von 0.1 bis 1000 mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>der Pfad einer Datei</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>der SHA-256 eines Blobs oder eine Datei</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>nichts: ein Netz liegt auf keiner Scheibe</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>ein Maßstab von 1e-9 bis 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>eine Deckkraft von 0 bis 1</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>ein Puffer mit Bytes</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>ein Puffer in der Datei</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>eine Länge, die sein Puffer hat</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>ein Zahlentyp, den es in glTF gibt</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>so viele Werte, wie sein Puffer hat</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>so viele Zahlen, wie dorthin gehören</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>ein Knoten, der nicht in sich selbst liegt</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>ein Abschnitt einer GLB-Datei</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>Version 2 von GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>eine glTF-Datei</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>Version 2 von glTF</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>es liegt in einem anderen Ordner</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>ein Netz</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>mindestens drei Ecken einer Fläche</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>die Zahl der Eckpunkte</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>die Zahl der Flächen</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>die Ecken einer Fläche</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>das Format</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element oder end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii oder binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>ein Typ wie float oder int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>zuerst ein Element</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>so viele Werte, wie die Datei angibt</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y und z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>die Länge einer Liste</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>die Zahl der Dreiecke</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>so viele Dreiecke, wie die Datei angibt</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet oder endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex oder endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>drei Ecken eines Dreiecks</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>in dieser Datei ist kein 3D-Modell</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>ein 3D-Modell</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>eine Einheit wie millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>zwölf Zahlen</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>ein Objekt, das sich nicht selbst enthält</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>ein Netz mit mindestens einem Dreieck</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>eine Kante mit drei oder mehr Flächen</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>ein Netz, in dem sich an einer Kante zwei Flächen treffen</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>ein Netz: dies ist flach</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>was %1 zeigt, ließ sich nicht lesen; sein Platz blieb</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>eine Vorlage ließ sich nicht lesen; ihr Platz blieb</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>das Bild ist beschädigt</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>der Rest des Bildes</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>das Bild ist hier beschädigt</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>ein Bild als PNG, JPEG oder WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>ein Bild mit mindestens einem Pixel</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>ein Bild oder eine Zeichnung</translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>%n Vorlage ließ sich nicht lesen; ihr Platz blieb.</numerusform>
            <numerusform>%n Vorlagen ließen sich nicht lesen; ihre Plätze blieben.</numerusform>
        </translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>keine der Stellen zwischen den Konturen lässt sich überdecken (%1), also gibt es keine Haut</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>keine Konturen kreuzen sich an ihren Rändern, also gibt es keine Haut</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Arbeitsspeicher reicht nicht</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>eine Farbe wie #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>eine Linienbreite in mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>eine Geschwindigkeit in mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>eine Zeile G-Code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>Zeilen G-Code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>das größte S</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>Breite und Höhe in mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>einen Anteil von 0 bis 1</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>mindestens drei Punkte</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon oder polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>mindestens ein Winkel</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>eine Aufgabe für einen Streifen</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>mindestens ein Stück</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>eine Maschine</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>jedes Teil einmal, in der Reihenfolge der Scheiben</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>jede Scheibe einmal, in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none, half, quarter oder free</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>eine größere Platte</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>eine Breite von Stegen in mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>eine Länge von Anschnitten in mm</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals oder groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>ein Ausdruck, der nicht so lang ist</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice oder switch</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>ein Wort aus Buchstaben und Ziffern, jedes einmal</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>jede Zahl einmal</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom oder top</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>ein Name ohne „=“, jeder einmal</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>jeder Wert einmal</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>was „%1“ folgen sollte, ist jetzt eine einfache Zahl</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n Zahl folgt nicht mehr dem, was für sie eingegeben war.</numerusform>
            <numerusform>%n Zahlen folgen nicht mehr dem, was für sie eingegeben war.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>eine Zeichnung</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>jede Maschine einmal, in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>Reststücke</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>einen Umriss ab 0, 0, der sich nicht selbst kreuzt</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>Dicken</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>was eine Platte haben kann</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>der Umriss ist offen: seine Enden liegen %1 mm auseinander</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>Koordinaten bis 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>platzierte Objekte</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckradius</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Innendurchmesser</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Langloch</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>Lässt sich nicht machen</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>FlatFitFab models</source>
        <translation>FlatFitFab-Modelle</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>glTF-Netze</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>OBJ-Netze</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>OFF-Netze</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>PLY-Netze</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>STL-Netze</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>3MF-Netze</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, Körper an ihrem Platz</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG in Originalgröße</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, eine je Platte</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, Haut als Netz</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, Haut als Netz</translation>
    </message>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF in Originalgröße</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, eine je Platte</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF für alte Programme, R12</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-Code für GRBL-Laser</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-Code, einer je Platte</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>LightBurn-Projekt</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, eins je Platte</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Stückliste für Tabellen</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, eine Seite je Platte</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, auf A4 verteilt</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, auf Letter verteilt</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, Körper an ihrem Platz</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, Körper flach liegend</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, Körper an ihrem Platz</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, Körper flach liegend</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Bild der Platten</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Bilder, eins je Platte</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Alles für die Werkstatt, gepackt</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Alles für die Werkstatt, in einem Ordner</translation>
    </message>
</context>
<context>
    <name>FullStop</name>
    <message>
        <source>%1.</source>
        <extracomment>%1 is a sentence; what ends one in this language</extracomment>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>&lt;kbd&gt;%1&lt;/kbd&gt; undoes it.</source>
        <extracomment>%1 is what is pressed; follows &quot;The contour crosses itself; the largest loop was kept.&quot;</extracomment>
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; nimmt es zurück.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>Nichts geändert: %1 und %2 lassen sich so nicht verbinden.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>Nichts gezeichnet: Alles liegt unter dem Boden, wo es abgeschnitten wird.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>Kein Loch gemacht: Es muss in %1 liegen und sie in einem Stück lassen.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Eine Scheibe in einem Zug auf den Boden zeichnen. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Eine Scheibe in einem Zug auf die Vorderebene zeichnen. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Eine Scheibe in einem Zug auf die Seitenebene zeichnen. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Eine Scheibe parallel zu %1 in einem Zug zeichnen. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Die neue Kontur von %1 in einem Zug zeichnen. &lt;kbd&gt;Esc&lt;/kbd&gt; behält die alte.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ein Loch in %1 in einem Zug zeichnen. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n Umriss von %1 passte nicht und wurde ausgelassen.</numerusform>
            <numerusform>%n Umrisse von %1 passten nicht und wurden ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 übergangen; %3.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 und %3 übergangen; %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n Text</numerusform>
            <numerusform>%n Texte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>%n Linie wurde gelesen</numerusform>
            <numerusform>%n Linien wurden gelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Die erste Scheibe zeichnen: drücken, ihre Form in einem Zug zeichnen, loslassen.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Ziehen dreht die Ansicht; mit &lt;kbd&gt;Umschalt&lt;/kbd&gt; wird eine Gruppe ausgewählt.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Aus %1 hinausziehen zeichnet eine Scheibe quer dazu; ein Klick wählt sie.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Ziehen verschiebt den Punkt; &lt;kbd&gt;Strg&lt;/kbd&gt; macht eine Ecke, Pfeiltasten verschieben um 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Ziehen biegt die Kurve; &lt;kbd&gt;Strg&lt;/kbd&gt; macht eine Ecke, &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält die Richtung.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Doppelklick fügt hier einen Punkt ein; Ziehen biegt die Kontur.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Ein Klick wählt die Verbindung von %1 und %2.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Ziehen macht den Schlitz von %1 tiefer und den von %2 flacher; ein Klick wählt die Verbindung.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Ziehen macht den Schlitz von %1 tiefer und den von %2 flacher; Pfeiltasten verschieben um 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 kommt von %2: Klick für alle, noch ein Klick für diese allein.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Klick wählt %1 allein aus; herausziehen zeichnet eine Scheibe quer dazu.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Ziehen verschiebt das Ende von %1; Klick, um es einzutippen.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Klick: von vorn ansehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Klick: von hinten ansehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Klick: von links ansehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Klick: von rechts ansehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Klick: von oben ansehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Klick: von unten ansehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Klick: auf diese Kante sehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Klick: auf diese Ecke sehen; Ziehen dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt ihn hier: Der Schlitz von %1 nimmt %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Entlang von etwas ziehen, dessen Länge bekannt ist; das ganze Modell folgt. &lt;kbd&gt;Esc&lt;/kbd&gt; beendet.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>So groß oder klein kann das Modell nicht werden.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Aus %1 hinausziehen, um mit der Feder quer dazu zu zeichnen; Klick wählt sie aus.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Klick setzt einen Punkt, Ziehen biegt; &lt;kbd&gt;Eingabe&lt;/kbd&gt; schließt, &lt;kbd&gt;Rücktaste&lt;/kbd&gt; nimmt einen zurück.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Klick setzt einen Punkt, Ziehen biegt; &lt;kbd&gt;Eingabe&lt;/kbd&gt; schließt, &lt;kbd&gt;Rücktaste&lt;/kbd&gt; nimmt einen zurück. Mit &lt;kbd&gt;Strg&lt;/kbd&gt; rastet nichts ein.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>Die Kontur kreuzt sich: &lt;kbd&gt;Eingabe&lt;/kbd&gt; behält die größte Schleife, &lt;kbd&gt;Rücktaste&lt;/kbd&gt; nimmt einen Punkt zurück.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Ziehen biegt; &lt;kbd&gt;Strg&lt;/kbd&gt; macht eine Ecke, &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält die Richtung.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Ziehen verschiebt den Punkt; mit &lt;kbd&gt;Strg&lt;/kbd&gt; rastet nichts ein, &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält die Richtung.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Am Griff ziehen biegt; &lt;kbd&gt;Strg&lt;/kbd&gt; macht eine Ecke.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Klick schließt die Kontur; Ziehen verschiebt den Punkt.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Eingabe&lt;/kbd&gt; setzt den Punkt, &lt;kbd&gt;Tab&lt;/kbd&gt; geht zur nächsten Zahl. &lt;kbd&gt;Esc&lt;/kbd&gt; schließt die Leiste.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Nicht geschlossen: Die Punkte umschließen noch nichts.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Eine Kontur ist noch offen: &lt;kbd&gt;Eingabe&lt;/kbd&gt; schließt sie, &lt;kbd&gt;Esc&lt;/kbd&gt; nimmt sie zurück.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Bisher: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Bisher: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; macht es.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; macht es. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Loslassen lässt ihn hier. &lt;kbd&gt;Strg&lt;/kbd&gt; macht eine Ecke, &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält die Richtung.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen wählt die Punkte darin. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 kann nicht auf %2 sitzen, denn diese sitzt auf ihr.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 und %2 treffen sich nicht: zuerst eine quer in die andere bewegen.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Ziehen dreht die Ansicht; &lt;kbd&gt;Leertaste&lt;/kbd&gt; spielt ab, &lt;kbd&gt;←&lt;/kbd&gt; und &lt;kbd&gt;→&lt;/kbd&gt; gehen schrittweise. &lt;kbd&gt;Esc&lt;/kbd&gt; schließt die Schritte.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>Das Modell hat sich geändert, daher wurde die Ansicht seiner Schritte geschlossen.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Weiterziehen, bis %1 verlassen ist; der Schlitz endet am Rand. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Die Kontur zeichnen, Loslassen schließt sie. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; macht die Scheibe fertig. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; schneidet das Loch in %1. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; gibt %1 diese Kontur. &lt;kbd&gt;Esc&lt;/kbd&gt; behält die alte.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; erzeugt die Scheibe, am Schlitz gespiegelt. &lt;kbd&gt;Umschalt&lt;/kbd&gt; behält nur diese Seite. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; erzeugt die Scheibe, gespiegelt. Ohne &lt;kbd&gt;Umschalt&lt;/kbd&gt; bleibt nur diese Seite. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; erzeugt die Scheibe, an der Senkrechten gespiegelt. &lt;kbd&gt;Umschalt&lt;/kbd&gt; behält nur diese Seite.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>Nichts gezeichnet: Die Linie ist zu kurz, um etwas zu umschließen.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>Nichts gezeichnet: Die Linie geht hin und zurück und umschließt nichts.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>Nichts gezeichnet: Die Linie kreuzt sich selbst, und keine Schleife davon ist groß genug.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 wurde nicht gespiegelt: Die beiden Hälften träfen sich nicht.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>Die Kontur kreuzt sich selbst; die größte Schleife blieb.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Ziehen bewegt %1; klicken wählt aus.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Ziehen bewegt; &lt;kbd&gt;Strg&lt;/kbd&gt; lässt eine Kopie da, &lt;kbd&gt;Umschalt&lt;/kbd&gt; bleibt bei einer Richtung.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Ziehen dreht; &lt;kbd&gt;Strg&lt;/kbd&gt; lässt eine Kopie da.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Ziehen skaliert; &lt;kbd&gt;Strg&lt;/kbd&gt; lässt eine Kopie da.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Eingabe&lt;/kbd&gt; macht %n solche Kopie. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</numerusform>
            <numerusform>&lt;kbd&gt;Eingabe&lt;/kbd&gt; macht %n solche Kopien, jede einen Schritt weiter. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Bewegen dreht die Ansicht, Loslassen beendet es.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Bewegen verschiebt die Ansicht, Loslassen beendet es.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>Nichts geändert: Das geht hier nicht.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 ist gesperrt. In der Gliederung entsperren, um sie zu ändern.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 kommt von %2: die Vorlage bearbeiten oder diese lösen.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 wurde am Boden eben abgeschnitten.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Auf die Scheibe klicken, an der gespiegelt wird; ziehen dreht die Ansicht. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>Nichts kopiert: Das Modell ist schon symmetrisch.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>Nichts gelöscht: Eine Verbindung ist, wo zwei Scheiben sich treffen. Lösche eine davon oder wähle die Art „Keine“.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 wird auf der Vorderseite graviert, der einzigen Seite, die der Laser erreicht; die Ansicht hat sich zu ihr gedreht.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: zum Kreis machen</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: zur Ellipse machen</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: Linien gerade machen</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Nichts gezeichnet: Eine Linie von weniger als %1 gilt als Ausrutscher, wenn sie keine Schleife schließt.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 ist nicht symmetrisch: ihre Hälften sind verschieden.</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: Schlitz vom Rand hereinrücken</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Weiter aus %1 hinaus ziehen. &lt;kbd&gt;Strg&lt;/kbd&gt; lässt den Schlitz, wie er gezeichnet ist. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Pfeiltasten bewegen das Gewicht von %1 auf %2 um 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; und &lt;kbd&gt;−&lt;/kbd&gt; ändern es, &lt;kbd&gt;Entf&lt;/kbd&gt; entfernt es.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Ziehen verschiebt das Gewicht von %1 auf %2; ein Klick wählt es aus.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Ziehen verschiebt den Druck von %1 auf %2, an der Spitze dreht es ihn; ein Klick wählt ihn aus.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Pfeiltasten verschieben den Druck von %1 auf %2 um 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; und &lt;kbd&gt;−&lt;/kbd&gt; ändern ihn, &lt;kbd&gt;Entf&lt;/kbd&gt; entfernt ihn.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Loslassen gibt es frei: nichts bleibt.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Ziehen verschiebt es. Ein &lt;b&gt;Klick&lt;/b&gt; wählt es aus.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Loslassen drückt hier. &lt;kbd&gt;Esc&lt;/kbd&gt; legt ihn zurück.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Klicken wählt Problem %1 aus.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>Nichts verschoben: Wo %1 und %2 sich treffen, teilen sich nicht zwei Schlitze den Weg.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>Nichts gedreht: Die Schlitze von %1 und %2 können nicht zur anderen Seite aufgehen.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>Nichts gekürzt: %1 steckt nicht in %2, oder es bliebe nichts davon.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Bewegen verschiebt den Schnitt, Loslassen lässt ihn dort. &lt;kbd&gt;Esc&lt;/kbd&gt; setzt ihn zurück.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>Die Ebene ist von der Kante zu sehen: Ansicht drehen, um weiterzuzeichnen.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Linienzug verworfen: Die Scheibe dazu gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>Nichts gezeichnet: Aus dieser Linie wird keine Scheibe. Als eine offene Schleife zeichnen.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>Das Loch reicht über den Rand von %1 und wurde aus ihm ausgeschnitten.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>Das Loch traf andere in %1; sie sind jetzt ein Loch.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>Löcher von %1, die außerhalb der neuen Kontur liegen, wurden weggelassen.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>Nichts importiert: Keine Linie in %1 schließt sich zu einem Umriss. Gravieren lassen sie sich.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: von der Mitte nach außen ziehen; ein Klick setzt die übliche Größe.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: von der Mitte nach außen ziehen, um es aus %2 auszuschneiden.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt es so groß; &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält beide Seiten gleich. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Ein Klick wählt %1. Ziehen dreht die Ansicht: Auf der Kante wird nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Ziehen, um den Schnitt durch das Modell zu bewegen; &lt;kbd&gt;Esc&lt;/kbd&gt; schließt ihn.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Runde Griffe verschieben Anfang und Ende von %1; ein Klick auf eine Scheibe wählt sie aus.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Ziehen verschiebt den Anfang von %1; Klick, um ihn einzutippen.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Auf eine Stelle einer Scheibe klicken, um %1 dorthin zu setzen. &lt;kbd&gt;Esc&lt;/kbd&gt; beendet es.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Auf eine Scheibe drücken und dorthin ziehen, wohin sie gedrückt wird. &lt;kbd&gt;Esc&lt;/kbd&gt; beendet.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Auf eine Scheibe drücken und daran ziehen, nur um zu sehen, was geschieht.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>An der Spitze ziehen: sie zeigt, wohin gedrückt wird, ein längerer Pfeil drückt stärker.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Loslassen setzt das Gewicht hierher. &lt;kbd&gt;Esc&lt;/kbd&gt; legt es zurück.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>Kein Gewicht hinzugefügt: auf eine Scheibe klicken.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>Dort ist nichts zu drücken: auf eine Scheibe drücken.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Die Kopie von %1 trägt es auch; unter &lt;i&gt;Eigenschaften&lt;/i&gt; lässt es sich auf diese Scheibe beschränken.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>Die Kopie von %1 trägt es auch; unter &lt;i&gt;Eigenschaften&lt;/i&gt; lässt es sich auf diese Scheibe beschränken.</numerusform>
            <numerusform>%n Kopien von %1 tragen es auch; unter &lt;i&gt;Eigenschaften&lt;/i&gt; lässt es sich auf diese Scheibe beschränken.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Das Gewicht bleibt, wo es ist: Dort wäre es neben %1.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Der Druck bleibt, wo er ist: dort wäre er neben %1.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Ziehen zeichnet eine Linie auf %1; &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält sie gerade. Klick setzt Text.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt die Linie so. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>Nichts graviert: Das liegt neben %1.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>Der Buchstabe „%1“ lässt sich nicht gravieren.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Zum Messen von einem Ort zum anderen ziehen; &lt;kbd&gt;Strg&lt;/kbd&gt; fängt nichts. &lt;kbd&gt;Esc&lt;/kbd&gt; beendet.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Zum zweiten Ort gehen. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Klicken oder ziehen misst von neuem. &lt;kbd&gt;Esc&lt;/kbd&gt; nimmt die Länge weg.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Gewünschte Länge eintippen; &lt;kbd&gt;Eingabe&lt;/kbd&gt; skaliert das ganze Modell. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>So weit lässt sich das Modell nicht skalieren: %1 käme aus seinem Bereich.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Loslassen: %1 beginnt hier, bei %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Loslassen: %1 endet hier, bei %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Aus einer Scheibe ziehen, um quer zu ihr zu zeichnen; hier ziehen dreht die Ansicht. &lt;kbd&gt;Esc&lt;/kbd&gt; legt die Feder weg.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Klick setzt den ersten Punkt, Ziehen biegt. &lt;kbd&gt;Esc&lt;/kbd&gt; legt die Feder weg.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Loslassen lässt es so. &lt;kbd&gt;Strg&lt;/kbd&gt; macht eine Ecke, &lt;kbd&gt;Umschalt&lt;/kbd&gt; hält die Richtung.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt es so. &lt;kbd&gt;Strg&lt;/kbd&gt; macht Ecken an den Enden. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>Hier würde sich die Kontur selbst kreuzen; sie bleibt, wie sie eben noch war.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Hier würde ein Loch den Rand oder ein anderes berühren; es bleibt, wie es eben noch war.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>Hier würde %1 am Boden ganz abgeschnitten; alles bleibt, wie es war.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>Nichts gelöscht: Eine Kontur braucht mindestens zwei Punkte.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen wählt alles aus, was ganz darin liegt. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 behält ihren Winkel zu %2. Freigeben, um sie beliebig zu drehen.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 sitzt auf keiner anderen Scheibe und hat daher keinen Winkel zu einer.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Die Scheibe anklicken, auf die %1 gesetzt werden soll. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Loslassen&lt;/b&gt; gibt %1 diese Kontur, am Schlitz gespiegelt. &lt;kbd&gt;Umschalt&lt;/kbd&gt; kehrt das Spiegeln um.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 wurde gespiegelt; was über die Achse und zurück lief, wurde weggelassen.</translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Auf die Scheibe klicken, die bewegt werden soll, oder sie ziehen. &lt;kbd&gt;Esc&lt;/kbd&gt; blendet die Griffe aus.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Pfeil ziehen bewegt, Ring dreht, Kästchen skaliert; oder Zahlen tippen. &lt;kbd&gt;Esc&lt;/kbd&gt; blendet die Griffe aus.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt es so. &lt;kbd&gt;Strg&lt;/kbd&gt; lässt eine Kopie da, &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt eine Kopie so da. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Eingabe&lt;/kbd&gt; lässt es so. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Nach oben geht es näher heran, nach unten weiter weg; Loslassen beendet es.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>Hier bliebe nichts von %1 übrig; alles bleibt, wie es war.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>Am Boden eben abgeschnitten zerfiel %1; das größte Stück blieb.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Der blaugrünen Linie folgen, um an %1 einzurasten; mit &lt;kbd&gt;Strg&lt;/kbd&gt; bleibt sie frei. &lt;kbd&gt;Umschalt+Eingabe&lt;/kbd&gt; nimmt sie ganz.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Umschalt+Eingabe: ganze Führung übernehmen</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>Der Schlitz berührt keine Führung, also ist keine ganz zu übernehmen.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 wurde neben ihrem Schlitz gezeichnet und bekam einen Steg, der in den Schlitz reicht.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 reicht nicht bis in ihren Schlitz: nichts verbindet sie mit %2.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 wurde neben ihrem Schlitz gezeichnet: Sie bekam einen Steg und wurde am Boden eben abgeschnitten.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Kein flaches Stück von %1 ist groß genug für eine Scheibe: Erst größer machen.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Es hat mehr als %1 flache Stücke: Weniger Flächen wählen.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Ziehen bestimmt, wie weit %1 Vorlagen anzieht.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Loslassen: %1 zieht Vorlagen ab %2 an. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: Ecken rechtwinklig</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 bleibt, wo es gezeichnet wurde: Hereingerückt würde sein Schlitz %2 zerschneiden. Quer über den Rand zeichnen, nicht an ihm entlang.</translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 liegt schräg zu %1: lege es zuerst auf die Ebene von %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 hat %n Umriss, das ist zu viel: zeichne es gröber nach oder glätte es zuerst.</numerusform>
            <numerusform>%1 hat %n Umrisse, das sind zu viele: zeichne es gröber nach oder glätte es zuerst.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nichts nachgezeichnet: kein Teil von %1 liegt auf dieser Seite der Schwelle.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>Nichts gezeichnet: Der Schlitz hat %1 nie verlassen. Innen beginnen und über den Rand ziehen; &lt;kbd&gt;O&lt;/kbd&gt; zeichnet Löcher, &lt;kbd&gt;E&lt;/kbd&gt; graviert.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1: Pfeil ziehen bewegt, Ring dreht, Kästchen skaliert; oder Zahlen tippen. &lt;kbd&gt;Esc&lt;/kbd&gt; blendet die Griffe aus.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Ziehen bewegt; &lt;kbd&gt;Umschalt&lt;/kbd&gt; bleibt bei einer Richtung.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Ziehen dreht.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Ziehen skaliert.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Loslassen lässt es so. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 ist gesperrt.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>So weit lässt sich %1 nicht bewegen oder skalieren.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Entlang von etwas in %1 ziehen, dessen Länge bekannt ist; &lt;kbd&gt;Umschalt&lt;/kbd&gt; bleibt bei acht Richtungen. &lt;kbd&gt;Esc&lt;/kbd&gt; beendet.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Eintippen, wie lang das ist; &lt;kbd&gt;Eingabe&lt;/kbd&gt; macht %1 so groß. &lt;kbd&gt;Esc&lt;/kbd&gt; löscht die Linie.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>Nichts eingefügt: In der Zwischenablage sind weder Scheiben noch ein Bild.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n, die daraus gemacht war, ist jetzt eine bloße Zahl.</numerusform>
            <numerusform>%n, die daraus gemacht waren, sind jetzt bloße Zahlen.</numerusform>
        </translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Eine Platte von %1 lässt sich nicht falten: Wähle ein Material von höchstens %2.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Falte entlang der geritzten Linien und verbinde dann Kanten mit derselben Nummer: %n Naht.</numerusform>
            <numerusform>Falte entlang der geritzten Linien und verbinde dann Kanten mit derselben Nummer: %n Nähte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ein Loch zeichnen: auf der Scheibe anfangen, die es bekommt. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Auf die Scheibe zeichnen, die graviert wird, oder sie anklicken. &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>Jetzt ein Kreis.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>Jetzt eine Ellipse.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Linien begradigt.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Ecken rechtwinklig gemacht.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Vom Rand weggerückt.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Jetzt die Kontur zeichnen: den grauen Bereich dort verlassen, wo sie beginnen soll. Loslassen bricht ab.</translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>Es wurden keine engeren Bereiche gefunden, in denen das Modell hält.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Ziehen dreht die Ansicht, das Rad zoomt.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>Die Ansicht dreht sich: Zeichne gleich weiter oder warte, bis sie stillsteht.</translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Eine Vorgabe braucht einen Namen, ohne „=“ und ohne Leerzeichen an den Enden.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>Es gibt keine Vorgabe namens „%1“.</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>Das sehen andere. Speichere die Datei und gib sie weiter; sie geht so auf.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Andere können noch keinen Wert anpassen, also gibt es nichts zu behalten.</translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>%n Vorgabe, die nichts anderes setzt, ist damit weg.</numerusform>
            <numerusform>%n Vorgaben, die nichts anderes setzen, sind damit weg.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>„%1“ ist jetzt, was eingestellt ist, anstelle von dem, was es war.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Zuerst eine Scheibe zeichnen: Noch ist nichts zu spiegeln da.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Zuerst eine Scheibe zeichnen: Noch ist nichts da, was sich wiederholen oder teilen lässt.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n Kante hat keine Fingerzinken: Ihre Scheiben treffen sich zu flach oder zu spitz, oder sie ist zu kurz. Weniger Flächen helfen, oder stattdessen Schnitte.</numerusform>
            <numerusform>%n Kanten haben keine Fingerzinken: Ihre Scheiben treffen sich zu flach oder zu spitz, oder sie sind zu kurz. Weniger Flächen helfen, oder stattdessen Schnitte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Fügt ein Spiegelbild der Auswahl hinzu. &lt;kbd&gt;Enter&lt;/kbd&gt; spiegelt; &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Was du auf einer Seite änderst, ändert sich auch auf der anderen. &lt;kbd&gt;Enter&lt;/kbd&gt; spiegelt; &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Macht beide Seiten einmal gleich; danach ist jede für sich. &lt;kbd&gt;Enter&lt;/kbd&gt; spiegelt; &lt;kbd&gt;Esc&lt;/kbd&gt; bricht ab.</translation>
    </message>
</context>
<context>
    <name>Listing</name>
    <message>
        <source>, </source>
        <extracomment>between the entries of a list in a sentence, with its blank</extracomment>
        <translation>, </translation>
    </message>
</context>
<context>
    <name>LoadPreset</name>
    <message>
        <source>Glass of water</source>
        <translation>Glas Wasser</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Gabel</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Messer</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Löffel</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Buch</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Blumentopf</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Eine Fläche wurde weggelassen: Eine ihrer Ecken gibt es nicht.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>%n Fläche wurde weggelassen: Eine ihrer Ecken gibt es nicht.</numerusform>
            <numerusform>%n Flächen wurden weggelassen: Eine ihrer Ecken gibt es nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Eine Fläche wurde weggelassen: Der Ort einer Ecke ist keine Zahl.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>%n Fläche wurde weggelassen: Der Ort einer Ecke ist keine Zahl.</numerusform>
            <numerusform>%n Flächen wurden weggelassen: Der Ort einer Ecke ist keine Zahl.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Eine Fläche wurde weggelassen: Sie hat eine Ecke doppelt.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>%n Fläche wurde weggelassen: Sie hat eine Ecke doppelt.</numerusform>
            <numerusform>%n Flächen wurden weggelassen: Sie haben eine Ecke doppelt.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Eine Fläche wurde weggelassen: Es gibt sie doppelt.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>%n Fläche wurde weggelassen: Es gibt sie zweimal.</numerusform>
            <numerusform>%n Flächen wurden weggelassen: Es gibt sie zweimal.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Eine Fläche zeigte in die falsche Richtung und wurde umgedreht.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n Fläche zeigte in die falsche Richtung und wurde umgedreht.</numerusform>
            <numerusform>%n Flächen zeigten in die falsche Richtung und wurden umgedreht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>Die Oberfläche hat ein Loch: Eine Kante ist offen.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>Die Oberfläche hat Löcher: %n Kante ist offen.</numerusform>
            <numerusform>Die Oberfläche hat Löcher: %n Kanten sind offen.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>An einer Kante treffen sich mehr als zwei Flächen.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>An %n Kante treffen sich mehr als zwei Flächen.</numerusform>
            <numerusform>An %n Kanten treffen sich mehr als zwei Flächen.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>An einer Kante treffen sich Flächen, die nicht in dieselbe Richtung zeigen können.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>An %n Kante treffen sich Flächen, die nicht in dieselbe Richtung zeigen können.</numerusform>
            <numerusform>An %n Kanten treffen sich Flächen, die nicht in dieselbe Richtung zeigen können.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>Innen war außen; es wurde umgedreht.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Eine Lücke im Schnitt wurde mit einer glatten Kurve geschlossen.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n Lücke im Schnitt wurde durch eine glatte Kurve geschlossen.</numerusform>
            <numerusform>%n Lücken im Schnitt wurden durch glatte Kurven geschlossen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>Wie</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 sagt nicht, wie groß die Zeichnung in mm oder Zoll ist; das Reststück wird mit %2 × %3 mm genommen.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: Der Umriss kreuzt sich selbst; genommen wird das größte Stück davon, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: Linien zerschneiden das Reststück; genommen wird das größte Stück, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: Im Reststück sind Linien offen; was sie geschlossen umschließen würden, bleibt frei.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Blend</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>Langsame Enden</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Von selbst</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Wie gezeichnet</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Gleiche Tiefe innen</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Wiederholt eine Scheibe in einer Reihe entlang einer anderen.</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Die Scheibe anklicken, die wiederholt werden soll.</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Wiederholen nach</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Größe ändern</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Nach örtlicher Dicke</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Ganze Scheibe</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>Entlang des Schlitzes</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>Nicht unter</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>Ganz herum</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Winkel zum Rand</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Wiederholt eine Scheibe um die Kontur einer anderen herum.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Größe einer Kopie</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Größe variieren ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Winkel variieren ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinste</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Verzweigung</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Die Scheibe anklicken, die sich verzweigt.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Gehalten von</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Die Scheibe anklicken, die sie hält: Kopien werden ebenso gehalten.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Kinder</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Teilt eine zu große Scheibe in Zellen, die zusammenhalten.</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Die Scheibe anklicken, die geteilt werden soll.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Passend zur Platte</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Breite einer Zelle</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Höhe einer Zelle</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Gerade, mit Verbindern</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Puzzle</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Verbinder je Kante</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Größe der Verbinder</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Reste vereinen unter</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Zahnrad</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Gezeichneter Sektor</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Sektoren</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Äußerer Radius</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Innerer Radius</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Eckig</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>Anwenden auf</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Rundform</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Die Scheibe anklicken, die geformt werden soll.</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Ganzes Modell</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegelung</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Die Scheibe anklicken, an der gespiegelt werden soll.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>Ebene einer Scheibe</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>An der Ebene verbinden</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Die zwei Scheiben anklicken, deren Schlitz die Achse ist.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Schlitz</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Ganzer Zweig</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Mit allem, was daran hängt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>Schritt X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Schritt Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Schritt Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Wiederholt Scheiben entlang einer Linie durch den Raum.</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Auf die Scheiben klicken, die wiederholt werden.</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Mit dem, was schon da ist</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>Muster %1</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Bildet Übergänge zwischen Scheiben.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>Übergang %1</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Die Scheiben anklicken, die ineinander übergehen sollen, der Reihe nach.</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Die Scheibe anklicken, an der sie entlanglaufen soll.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Anzahl je Lücke</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Setzt eine Scheibe mit allem, was daran hängt, an die Stelle ihrer Kinder, immer wieder.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>Verzweigung %1</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Die anhängenden Scheiben anklicken, die Kopien ersetzen sollen.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>Raster %1</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>Von jeder liegt gleich viel in der anderen Scheibe</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>Reihe %1</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>Kreis %1</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>Stern %1</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>Löcher %1</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>Rosette %1</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>Zahnrad %1</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Macht eine Scheibe zu Kreis, Stern oder Zahnrad oder setzt solche Löcher hinein.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>Fächer %1</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Die Scheiben anklicken, um die es geht.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Gilt für</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Was auf einer Seite gezeichnet ist, steht auch auf der anderen.</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Was einmal gezeichnet ist, steht rings um eine Achse.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>quer zu X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>quer zu Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>quer zu Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>quer zu X und Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>quer zu X und Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>quer zu Y und Z</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>In jeder Richtung</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>Aller Ebenen, als Teil ihres Abstands</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Kleinstes Stück</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Hohl</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Nur eine Wand entlang der Kontur bleibt</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Schneidet ein Netz in Scheiben, die seiner Form folgen.</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>entlang einer Kurve</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Die Scheibe anklicken, an deren Kontur entlang es laufen soll.</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>In mm²; kleinere werden weggelassen, und solche, die überall dünn sind</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>wie eine Scheibe</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>um Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>um X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>um Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Die Scheibe anklicken, zu der sie parallel sein sollen.</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 macht nichts: die Scheiben kreuzen einander nicht.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 macht nichts: im Bereich ist kein Platz.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 hat bei %n Scheibe aufgehört.</numerusform>
            <numerusform>%1 hat bei %n Scheiben aufgehört.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%n Scheibe von %1 wurde ausgelassen, weil nichts da ist, was sie hält.</numerusform>
            <numerusform>%n Scheiben von %1 wurden ausgelassen, weil nichts da ist, was sie hält.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 hat bei 1 Scheibe aufgehört.</translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 Scheibe von %1 wurde ausgelassen, weil nichts da ist, was sie hält.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>von selbst</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1&#x202f;mm</source>
        <translation>%1&#x202f;mm</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ließ sich nicht berechnen: Scheiben davon fehlen.</translation>
    </message>
    <message>
        <source>%1 makes nothing yet: choose its “%2”.</source>
        <extracomment>%1 is the name of an operation, %2 what it asks for: &quot;Along&quot;</extracomment>
        <translation>%1 macht noch nichts: es fehlt, was unter „%2“ steht.</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 hat die Scheibe „%2“ verloren, die gelöscht wurde. Es macht nichts, bis eine andere gewählt ist.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 hat nichts zu teilen: Die Scheibe passt in eine einzige Zelle.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ergibt nichts: Die Vorlage ist weg, oder ihre Datei fehlt.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 kleines Stück von %1 wurde weggelassen.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>1 kleines Stück von %1 wurde weggelassen.</numerusform>
            <numerusform>%n kleine Stücke von %1 wurden weggelassen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: mit 100 % drucken</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Platte %1, Seite %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <extracomment>keys, as they are labelled on a keyboard of the country, in menus: &quot;Ctrl+Shift+S&quot;</extracomment>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Meta</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>the joints and slits</source>
        <translation>Verbindungen und Schlitze</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>die Prüfungen</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>die Reihenfolge des Zusammenbaus</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>was Teile löst, die sich gegenseitig sperren</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>was gegen Probleme hilft</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Wird ermittelt: %1 …</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>Wird ermittelt: %1 … %2&#x202f;%</translation>
    </message>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Angehalten: %1. Wird neu ermittelt, wenn sich das Modell ändert.</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>ob es hält</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>Nicht zu ermitteln: %1. Der Grund: %2.</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>was es mit biegsamen Scheiben trägt</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>was jede Stelle einer Scheibe trägt</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>was Magnete aus Vorlagen machen</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>die Haut</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>wie die Teile auf den Platten liegen</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Material von %1 wechseln</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Material von %n Scheibe wechseln</numerusform>
            <numerusform>Material von %n Scheiben wechseln</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Auf den Boden setzen</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 und %2 verbinden</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>%1 zu %2 verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>%n Scheibe zu %1 verschieben</numerusform>
            <numerusform>%n Scheiben zu %1 verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Baubar machen</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 bis zum Boden verlängern</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>%n Scheibe bis zum Boden verlängern</numerusform>
            <numerusform>%n Scheiben bis zum Boden verlängern</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: Schlitze umdrehen</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: Treffpunkt → %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: Art → Kreuzüberblattung</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: Art → lange Überblattung</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: Art → Zapfenloch</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: Art → Zapfen</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: Art → keine Verbindung</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 an %2 kürzen</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 neu zeichnen</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Loch in %1 zeichnen</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 zeichnen</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>%1 einlesen</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Form von %1 ändern</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 beschriften</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Markierung von %1 ändern</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Markierung von %1 löschen</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Modell auf %1 % skalieren</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punkt zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punkt von %1 löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>%n Punkt von %1 löschen</numerusform>
            <numerusform>%n Punkte von %1 löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Griff von %1 verschieben</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kontur von %1 biegen</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punkt von %1 verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>%n Punkt von %1 verschieben</numerusform>
            <numerusform>%n Punkte von %1 verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punkt von %1 ändern</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>%n Punkt von %1 ändern</numerusform>
            <numerusform>%n Punkte von %1 ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 bewegen</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>%n Scheibe bewegen</numerusform>
            <numerusform>%n Scheiben bewegen</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 drehen</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>%n Scheibe drehen</numerusform>
            <numerusform>%n Scheiben drehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 skalieren</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>%n Scheibe skalieren</numerusform>
            <numerusform>%n Scheiben skalieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 kopieren</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>%n Scheibe kopieren</numerusform>
            <numerusform>%n Scheiben kopieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kopie von %1 spiegeln</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Kopie von %n Scheibe spiegeln</numerusform>
            <numerusform>Kopien von %n Scheiben spiegeln</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 rechtwinklig stellen</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>%n Scheibe rechtwinklig stellen</numerusform>
            <numerusform>%n Scheiben rechtwinklig stellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 an einer Achse ausrichten</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>%n Scheibe an einer Achse ausrichten</numerusform>
            <numerusform>%n Scheiben an Achsen ausrichten</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 auf eine andere Scheibe setzen</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 freigeben</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>%n Scheibe freigeben</numerusform>
            <numerusform>%n Scheiben freigeben</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 sperren</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>%n Scheibe sperren</numerusform>
            <numerusform>%n Scheiben sperren</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 entsperren</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>%n Scheibe entsperren</numerusform>
            <numerusform>%n Scheiben entsperren</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a section
----------
%1 is the name of a number
----------
%1 is the name of an operation</extracomment>
        <translation>%1 löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>%n Scheibe löschen</numerusform>
            <numerusform>%n Scheiben löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <extracomment>%1 is the name of an operation, %2 of what it works on (&quot;Along&quot;), %3 of a section</extracomment>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <extracomment>%1 is the name of an operation, %2 of a number (&quot;Count&quot;), %3 and %4 what it was and is</extracomment>
        <translation>%1: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Change %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Reihenfolge von %1 ändern</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>%1 auslassen</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>%n Scheiben auslassen</numerusform>
            <numerusform>%n Scheiben auslassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 ausschneiden</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>%n Scheibe ausschneiden</numerusform>
            <numerusform>%n Scheiben ausschneiden</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 einfügen</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>%n Scheibe einfügen</numerusform>
            <numerusform>%n Scheiben einfügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Maß behalten</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Maß löschen</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>%1 festlegen</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 in Gezeichnetes umwandeln</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>%1 lösen</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Symmetrisch machen</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Löcher von %1 entfernen</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Löcher von %n Scheibe entfernen</numerusform>
            <numerusform>Löcher von %n Scheiben entfernen</numerusform>
        </translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Standfläche von %1 verbreitern</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 einen Fuß geben</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 um %2 verschieben</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 auf 90° drehen</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 zum Kreis machen</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 zur Ellipse machen</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Loch in %1 zum Kreis machen</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Loch in %1 zur Ellipse machen</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Linien von %1 gerade machen</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ecken von %1 rechtwinklig machen</translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 symmetrisch halten</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>%n Scheibe symmetrisch halten</numerusform>
            <numerusform>%n Scheiben symmetrisch halten</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Hälften von %1 verschieden sein lassen</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Hälften von %n Scheibe verschieden sein lassen</numerusform>
            <numerusform>Hälften von %n Scheiben verschieden sein lassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 vom Rand hereinrücken</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Gewicht an %1 verschieben</translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 auf %2 Dicke ändern</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 drücken</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Druck auf %1 verschieben</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Druck auf %1 drehen</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 breiter machen, wo sie schwach ist</translation>
    </message>
    <message>
        <source>Set up cutting</source>
        <translation>Schneiden einrichten</translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Schlitze von %1 umdrehen</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: wieder automatisch</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>%1 auf %2 setzen</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Gewicht auf %1 setzen</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Ein Gewicht %1 nennen</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Gewicht entfernen</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Druck auf %1 setzen</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Druck %1 nennen</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Druck entfernen</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Verteilen, was auf %1 wirkt</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kopien von %1 tragen, was darauf wirkt</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kopien von %1 ohne das, was darauf wirkt</translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 anhängen</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>%n Scheibe anhängen</numerusform>
            <numerusform>%n Scheiben anhängen</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Ausgelassene Scheibe wieder machen</translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 entfernen</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 ändern</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 verschieben</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 ausblenden</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 einblenden</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 mit einem Fuß stützen</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n Scheibe für %1 vorschlagen</numerusform>
            <numerusform>%n Scheiben für %1 vorschlagen</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 aus Flächen bauen</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Vorlagen an %1 ziehen</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Vorlagen an %n Scheibe ziehen</numerusform>
            <numerusform>Vorlagen an %n Scheiben ziehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Vorlagen von %1 lösen</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Vorlagen von %n Scheibe lösen</numerusform>
            <numerusform>Vorlagen von %n Scheiben lösen</numerusform>
        </translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 nachzeichnen</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>%1 und %2 ausrichten</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 drehen</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vorlage %1 skalieren</translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>%1 auf der Platte verschieben</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>%1 anheften</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>%n Teil anheften</numerusform>
            <numerusform>%n Teile anheften</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>%1 lösen</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>%n Scheibe lösen</numerusform>
            <numerusform>%n Scheiben lösen</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Alle Teile lösen</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Drehung von %1 ändern</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Drehung von %n Scheibe ändern</numerusform>
            <numerusform>Drehung von %n Scheiben ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 abwickeln</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Zum Anpassen weitergeben</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Entwurf bearbeiten</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Werte einstellen</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Bereiche einengen</translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Ändern, wie %1 folgt</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Ändern, wie %n Scheibe folgt</numerusform>
            <numerusform>Ändern, wie %n Scheiben folgen</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Vorgabe %1 behalten</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Auf %1 setzen</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Vorgabe %1 löschen</translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Ebenen von %1 versetzen</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Zahl der Ebenen von %1 ändern</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Abstand der Ebenen von %1 ändern</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 ist zu klein oder zu dünn für Scheiben, die %2 dick sind.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Von %1 wurden keine Scheiben gefunden, die einander halten und stehen.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Von %1 wurde keine weitere Scheibe gefunden, die zwischen die vorhandenen passt.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Von %1 wurde nur %n Scheibe gefunden: Jede weitere wäre ihr im Weg oder hätte keinen Halt.</numerusform>
            <numerusform>Von %1 wurden nur %n Scheiben gefunden: Jede weitere wäre ihnen im Weg oder hätte keinen Halt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n Scheibe von %1 ist das Wenigste, was steht.</numerusform>
            <numerusform>Weniger als %n Scheiben von %1, die stehen, wurden nicht gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 wurde um %2 in den Boden abgesenkt, damit die Scheiben auf flachem Fuß stehen.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 wurde um %2 in den Boden abgesenkt, und die Scheiben haben bis zu %3 hohe Füße, damit sie stehen.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>Es bewegt sich; nur sein erstes Bild wird gezeigt.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n Text wurde ausgelassen.</numerusform>
            <numerusform>%n Texte wurden ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n Bild wurde ausgelassen.</numerusform>
            <numerusform>%n Bilder wurden ausgelassen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Es fehlt eine Zahl, ein Name oder eine Rechnung.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Ein Ausdruck hat höchstens %1 Zeichen; dieser ist länger.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>Bei „%1“ hat der Ausdruck mehr als %2 Zahlen, Namen und Zeichen.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>Bei „%1“ stehen mehr als %2 Klammern oder Vorzeichen ineinander.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>„%1“ kann hier nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Hinter „%1“ fehlt etwas.</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Vor „%1“ fehlt etwas.</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Zwischen „%1“ und „%2“ fehlt ein Zeichen wie + oder *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>Die Klammer bei „%1“ ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Nach „%1“ steht eine schließende Klammer zu viel.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>Dem Text bei „%1“ fehlt das schließende Anführungszeichen.</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>„%1“ kann eine Zahl oder zwei sein: Schreib einen Punkt oder ein Leerzeichen nach dem Komma.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>„%1“ ist eine Einheit; davor gehört eine Zahl.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>„%1“ lässt sich auf zwei Arten verstehen: Setz „%2“ in Klammern.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>„%1“ ist ein zweiter Vergleich; and(…; …) verbindet zwei davon.</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>Es gibt keine Funktion namens „%1“.</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>„%1“ braucht in der Klammer genau %2, nicht %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>„%1“ braucht in der Klammer mindestens %2, nicht %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>„%1“ nimmt in der Klammer höchstens %2, nicht %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Es gibt keinen Wert namens „%1“.</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>„%1“ ist die Dicke des Materials; hier gibt es nicht nur ein Material.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>„%1“ ist %2 und kann deshalb keine eigene Einheit haben.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>„%1“ ist %2 und „%3“ ist %4; nur Gleichartiges lässt sich addieren oder vergleichen.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>„%1“ ist %2; damit lässt sich nicht rechnen.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>„%1“ ist %2; gebraucht wird hier %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>„%1“ ist %2; als Exponent geht nur eine kleine ganze Zahl wie 2, nicht „%3“.</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>„%1“ multipliziert zu viele Längen, Winkel oder Massen.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>„%1“ ist %2; daraus gibt es keine Wurzel.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>„%1“ ist 0, und durch 0 lässt sich nicht teilen.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>„%1“ ist negativ und hat keine Wurzel.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>Der Tangens von „%1“ ist unendlich.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>„%1“ liegt nicht zwischen −1 und 1 und gehört deshalb zu keinem Winkel.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>„%1“ ist nicht größer als 0; auf solche Schritte lässt sich nicht runden.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>„%1“ ist zu groß.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>„%1“ ist %2, keine ganze Zahl; round, floor oder ceil machen eine daraus.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>„%1“ ist %2; es muss mindestens %3 sein.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>„%1“ ist %2; es darf höchstens %3 sein.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>„%1“ ist „%2“; das steht nicht zur Wahl.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>„%1“ ergibt einen Text von mehr als %2 Zeichen.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Dieser Wert hängt von sich selbst ab: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Dieser Wert hängt von „%1“ ab, und das hat gerade keinen.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Zwei Werte heißen „%1“.</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>„%1“ ist kein Name; ein Name ist ein Buchstabe, dann Buchstaben, Ziffern und _, höchstens %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>„%1“ kann kein Name sein, denn es bedeutet in Ausdrücken schon etwas.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Diesen Wert gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>Die geschweifte Klammer bei „%1“ ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>eine reine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>ein Winkel</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>eine Masse</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>ein Ja oder Nein</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>weder Länge, Winkel, Masse noch reine Zahl</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Scheibe %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Scheiben %1</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>Usage: %1</source>
        <translation>Aufruf: %1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Zeigt diese Hilfe.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Zu viele Dateien: %1</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Dicke jedes Materials.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Ganze Breite, die die Maschine wegnimmt.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: gefunden: „%1“, erwartet: Breite x Höhe in mm, etwa 600x400.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>Die Datei, die geschrieben wird; - ist die Standardausgabe.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Lässt den 100-mm-Balken neben den Platten weg.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>Das Modell, mit dem begonnen wird; ohne Angabe ein neues.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: gefunden: „%2“, erwartet: eine Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: gefunden: „%2“, erwartet: eine Zahl von 0 bis %3.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: gefunden: „%1“, erwartet: groups oder files.</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files braucht einen Namen: Die Standardausgabe ist nur eine Datei.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Teile: %1, Platten: %2, %3 % genutzt.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Vom Rand der Platte zum nächsten Schnitt (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Zwischen benachbarten Schnitten (2).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: ein SVG mit einer Gruppe je Platte; files: OUT-1.svg, OUT-2.svg und so weiter (groups).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: gefunden: „%1“, erwartet: Breite x Höhe in Pixeln bis %2, etwa 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: gefunden: „%1“, erwartet eines von: %2.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>Die PNG-Datei, die geschrieben wird; - ist die Standardausgabe.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Pixel des Bildes (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 bis iso4, front, right, top, left, back, bottom oder fit: wieder die Vorderseite (iso1).</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Ein Bild braucht eine Anzeige mit OpenGL 3.3; es gibt keine.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size gilt für .png; ein PDF hat die Größe seines Papiers.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper gilt für .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: gefunden „%1“, erwartet a4 oder letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Schritt %1: Teil %2</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: Eine Datei braucht einen Namen.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>eine %1-Datei</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>eine %2-%1-Datei</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Scheiben: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Verbindungen: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 und %2 treffen sich, aber kein Schlitz lässt sie zusammenstecken.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Alle Scheiben halten zusammen.</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Nicht mit dem Rest verbunden: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Größe %1 × %2 × %3 mm (Breite, Höhe, Tiefe)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Masse %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Material %1, %2 mm, Platten von %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Teil %1: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, Verbindungen %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>Nichts zu schneiden: Die Schlitze lassen von keiner Scheibe etwas übrig.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>Das Modell hat keine Operationen.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 Scheibe</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Steht.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Fällt um.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Ein Teil davon hat nichts, worauf er steht.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Rutscht auf dem Boden weg.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Hält.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Hält knapp: In einer Ecke kann es reißen.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Bricht.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Eine Verbindung wird auseinandergezogen.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Nicht bewertet: Die Festigkeit eines Materials ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Ob es hält, konnte nicht ermittelt werden.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 drückt mit %2 N auf den Boden.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a file&apos;s name, %2 a sentence about what is in it
----------
%1 are names of stocks, %2 is a sentence</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>Die Spannung in %1 konnte nicht ermittelt werden.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: erwartet wird NAME=MASSE, zum Beispiel „Rib 4=350g“.</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: hinter dem = wird eine Masse über 0 und bis 1000000 kg erwartet, mit g, kg, oz oder lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: Eine Scheibe „%2“ gibt es nicht.</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: Schlitze lassen von „%2“ nichts übrig.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 insgesamt</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1 N insgesamt</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Kann ab %1 einreißen.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Bricht bei %1.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Spannung mit finiten Elementen, farbig über die ganzen Scheiben; dauert Sekunden.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 lässt im Material %2 keinen Schlitz: Sein Spiel ist %3 mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 passt nicht zum Material %2, %3 mm dick.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>Eine Datei fehlt.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Spiel, das Schlitze bekommen; negativ klemmt.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Sagt zu allem, was in der Datei berichtigt wurde, an welcher Stelle.</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Schritt %1: mit Teil %2 beginnen</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Schritt %1: daneben mit Teil %2 beginnen</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Schritt %1: die Teile %2 zusammen; das verbindet, was mit den Schritten %3 und %4 zusammengesetzt ist</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>ein Teil von %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>Nichts zu schneiden: Das Modell hat keine Scheibe.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>Schlitze sind %1 mm breit gezeichnet.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>Schlitze sind %1 mm breit gezeichnet (%2 − %3 Schnittfuge).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Platten eines früheren Exports sind noch da: %1</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1, wo der Dateiname es nicht sagt.</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Nur Vierteldrehungen, für Platten mit Faserrichtung.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>-o fehlt: die Datei, die geschrieben wird.</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Bei -o - fehlt die Art: --format %1.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: Diese Art Datei lässt sich nicht schreiben; erwartet: %2.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>Ist in sich beweglich.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>Was nicht stillsteht, wird nicht auf Festigkeit geprüft.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>Die Verbindung %1–%2 wird mit %3 N gezogen: kleben oder die Schlitze umdrehen.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>%1 ließ sich nicht als Platte berechnen, die sich biegt, und gilt als starr.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>Wie sich die Scheiben biegen, konnte nicht ermittelt werden; sie gelten als starr.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Die Verbindungen können die Last auf mehr als eine Weise tragen (unbestimmt, %1): Die schlimmste von mehreren zählt.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 ist nicht bewertet: Die Festigkeit des Materials ist nicht bekannt.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Ein Druck von %1 N trifft kein Material von %2; das nächste Stück davon trägt ihn.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Ein Gewicht von %1 liegt auf keinem Material von %2; die nächste Stelle trägt es.</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>dem %1-fachen der Last</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>Am schwächsten in %1: im Hals %2 dessen, was das Material trägt, in der Ecke %3.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Biegt sich um %1 mm, am meisten %2.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Wiegt mit allem, was darauf ist, %1 N.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Gibt JSON aus, für andere Programme.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Gibt JSON aus, für andere Programme; Schritte werden ab 0 gezählt.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Größter Abstand der Sehnen von den Kurven (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: Diese Art Datei lässt sich nicht schreiben; erwartet: .png.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: Es werden keine Kräfte gezeigt, denn es steht nicht, oder sie konnten nicht ermittelt werden. „check“ sagt, warum.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>Aus dem Bild ließ sich keine PNG-Datei machen.</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 oder letter (wie es am Ort üblich ist).</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Setzt ein Gewicht auf eine Scheibe, in ihre Mitte oder bei X,Y in mm: „Rib 4=350g“, „Rib 4@10,25=0.35kg“. Beliebig oft.</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Flächen: %1, Hüllen: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>Die Ebene schneidet es nicht.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Loch: %1 mm², %2 Punkte</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Umriss: %1 mm², %2 Punkte</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Fläche: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Ein Punkt der Ebene und ihre Normale, sechs Zahlen mit Kommas.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Bringt das Netz zuerst auf diese größte Ausdehnung und stellt es auf den Boden.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>--plane fehlt.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: &quot;%1&quot; gefunden, erwartet sind sechs Zahlen, die letzten drei davon eine Richtung.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: gefunden: „%2“, erwartet: eine ganze Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Wie viele Scheiben (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Eine andere Zahl ergibt andere Scheiben (1).</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>Die .fff-Datei, die geschrieben wird; - ist die Standardausgabe.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Skaliert das Netz auf diese größte Ausdehnung; ohne sie so groß, wie seine Datei sagt, sonst 254.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Keine Fingerzinken, wo Platten in weniger als 30° oder mehr als 150° aufeinandertreffen: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Keine Fingerzinken, wo eine Platte an der anderen vorbeigeht oder sie nicht erreicht: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Keine Fingerzinken an Kanten, die für drei davon zu kurz sind: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: hat %2 flache Stücke, erwartet: höchstens %3; mit --faces werden es weniger.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: kein flaches Stück davon ist groß genug für eine Scheibe; mit --size wird es größer.</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Vereinfacht das Netz zuerst auf so viele Dreiecke; die in einer Ebene liegen, sind ein Stück.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Zu kleine Stücke für eine Scheibe: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Scheiben: %1, Verbindungen: %2</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: gefunden: „%1“, erwartet: X, Y, Z, XY, XZ, YZ oder radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>--count und --spacing wurden beide angegeben; erwartet: eines davon.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: Ebenen um eine Achse haben keinen Abstand; erwartet: --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>Die Achsen, zu denen Ebenen quer liegen: X, Y, Z, zwei davon für ein Raster, oder radial: um die senkrechte Achse (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Ebenen in jeder Richtung (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>Von Ebene zu Ebene.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: keine Ebene schneidet davon eine Scheibe, die groß genug ist.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Stellt ein Netz, ein Bild oder eine Zeichnung (SVG) neben das Modell, auf Wunsch mit dieser größten Ausdehnung in mm; mehrmals möglich.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: gefunden: „%1“, erwartet: eine Datei oder eine Datei und ihre Größe in mm, etwa ball.stl@80.</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Flächenstücke: %1, Dreiecke: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Stellen, die offen bleiben: %1</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: solche Dateien können sie nicht enthalten; erwartet: %1.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: gefunden: „%1“, erwartet: labels, checks, stress, forces, skin oder mehrere, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: die Namen der Scheiben; checks: umrandet Scheiben mit einem Problem; stress: die schwächsten Querschnitte; forces: was Füße und Verbindungen tragen; skin: die Form, die die Scheiben andeuten.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Würde stehen, %1.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: gefunden „%2“, erwartet %3.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: Eine Maschine „%1“ gibt es nicht; erwartet %2 oder eine .json-Datei.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: %2 m Schnitte, etwa %3 min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>Platten sind größer als ihr Bett von %1 x %2 mm; wähle andere mit --sheet.</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>Die Maschine, die schneidet, für ihre Farben, Geschwindigkeiten und ihren G-Code: %1; oder eine .json-Datei mit einer eigenen (generic).</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Wie lange gesucht wird (10); 0 nimmt die erste Anordnung.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Eine andere Zahl gibt eine andere Anordnung, dieselbe Zahl dieselbe.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Wie Teile gedreht werden dürfen: none (gar nicht), 180, 90 oder free (beliebig).</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Vom Rand der Platte zum nächsten Schnitt.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Zwischen benachbarten Schnitten.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: gefunden: „%1“, erwartet: none, 180, 90 oder free.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Länge: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Dichte: %1 %</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Teile: %1, Platten: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm, %3: %4 Teile, %5 % bedeckt</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: Ein Teil ist zu groß für seine Platte.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: Dieses Stück ist zu groß für den Streifen.</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Schreibt die Form, die die Scheiben andeuten, als Fläche (%1), an Stelle der Körper.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Hielte, %1.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Legt Teile nach ihren wahren Umrissen aus und sucht so viele Sekunden; 0 nimmt die erste Anordnung (nach ihren Rechtecken).</translation>
    </message>
    <message>
        <source>Push all %1 slats together: what their width is less than %2 mm, divided by %1, is the kerf.</source>
        <translation>Alle %1 Leisten zusammenschieben: Was ihrer Breite an %2 mm fehlt, geteilt durch %1, ist die Schnittfuge.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Stege, die jedes Teil in seiner Platte halten, und ihre Breite in mm, etwa 3:0.4 (keine).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Beginnt und beendet jeden Schnitt so weit neben seiner Linie, im Abfall (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Schneidet Kanten zweier Teile, die aufeinander liegen, nur einmal; mit --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Schreibt statt der Teile ein Probestück: Schlitze mit nummerierten Breiten und Leisten, die die Schnittfuge verraten.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: gefunden: „%1“, erwartet: eine Zahl von 0 bis %2, dann ein Doppelpunkt und eine Breite von %3 bis %4.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: Diese Art Datei kann es nicht enthalten; erwartet: %1.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Schneidet jede Scheibe aus diesem Material oder aus dem einer .fff-Datei.</translation>
    </message>
    <message>
        <source>--set: %1</source>
        <translation>--set: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>„%1“ gefunden, NAME=WERT erwartet, etwa width=400.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>das Modell hat keine benannten Werte.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>es gibt keinen Wert „%1“; erwartet: %2.</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>Das Modell hat keine benannten Werte.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>es sind mehr Zellen als Namen.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Eine CSV-Datei: Namen von Werten und je Variante eine Zeile mit Zahlen.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>Der Ordner, in den geschrieben wird; er wird angelegt, wenn es ihn nicht gibt.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>Was von jeder geschrieben wird (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>--table und -o sind beide nötig.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: „%1“ gefunden, eine Art von Schneiddatei erwartet.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: keine Zeile mit Zahlen gefunden, unter den Namen wird eine erwartet.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: ein Anführungszeichen ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: der Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>Es gibt kein Material „%1“. Wähle eines der Datei oder eines aus der Liste der Materialien, etwa Birch plywood, Acrylic oder Card.</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Eine Platte von %1 mm lässt sich nicht falten, erwartet höchstens %2 mm; --stock wählt eine andere.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Netze: %1, Falze: %2, Nähte: %3</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Netze zum Falten entlang geritzter Linien, aus Platten bis 3 mm, statt flacher Platten.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Mit --unfold: Breite der Klebelaschen; 8 mm bei Platten bis 1,5 mm, sonst 0 mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap gehört zu --unfold.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Zu schwach: Es hält, aber nicht mit der verlangten Sicherheit.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Fällt um: Es steht nur auf einer einzigen Linie.</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Wo:</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Eine andere Zahl probiert andere Stellen, dieselbe dieselben.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>Es ist nicht auf dem Boden.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Probiert: %1 von %2 Ecken der Bereiche, %3 Varianten dazwischen.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Alle sind gut.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 von %2 taugen nicht:</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Gibt einem benannten Wert des Modells eine andere Zahl, oder alles, was eine Vorgabe setzt; darf mehrmals stehen.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>„%1“ gefunden, erwartet wurde NAME=WERT, etwa width=400, oder eine Vorgabe: %2.</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Vorgaben: %1. Gesetzt ist %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Vorgaben: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>&quot;%1&quot; kann %2 oder %3 sein; bitte schreibe eines davon.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Kein Wert, den andere anpassen können, hat einen Bereich und wird benutzt.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Probiert die Bereiche der Werte, die andere anpassen können.</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: zwei Spalten heißen &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: Diese Art Datei lässt sich nicht schreiben; erwartet: .pdf, .html oder .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size gilt für .png; eine Webseite passt sich dem Bildschirm an.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>Ein Bild der Schritte ließ sich nicht machen.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Eine PDF-Datei mit allen Schritten (- ist die Standardausgabe), OUT.html für eine Webseite, auf der sich das Modell drehen lässt, auch am Telefon, oder OUT.png für OUT-01.png, OUT-02.png und so weiter.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: so viele Reststücke des Materials %1 sind zu viele.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Platten aus %1, die fehlen: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Die Schritte sind nicht bei den Dateien: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Platten aus %1 haben innerhalb der Ränder von %2 mm keinen Platz.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: „%1“ gefunden, erwartet wird Breite x Höhe in mm, etwa 300x200, oder eine .svg-Datei, und dahinter, wie viele es sind, etwa :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Größe einer Platte, etwa 600x400; mit :N dahinter, wie viele es gibt.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: Das Modell hat kein Material „%2“; es wird aus %3 geschnitten.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: Das Modell wird aus %2 geschnitten. Bitte sagen, wovon dieses ist, etwa „%3=%1“.</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Eine Platte anderer Größe, oder was von einer übrig ist, als größter Umriss einer .svg-Datei in wahrer Größe, die vor ganzen aufgebraucht wird; mit :N dahinter so viele davon. Bei einem Modell aus mehreren Materialien mit dessen Namen davor: „Birch plywood=300x200“. Kann wiederholt werden.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Lässt nur Wände dieser Breite entlang der Konturen stehen, und wo andere kreuzen.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Graviert die Nummern jeder Verbindung in einer eigenen Farbe, die auf beiden Teilen dieselbe ist.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: Diese Art Datei kann sie nicht aufnehmen; erwartet wird %1.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Für zwei Teile einmal geschnitten: %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>Keine Kanten zweier Teile liegen aufeinander: Nichts wird nur einmal geschnitten. Mit --spacing 0 können es gerade Kanten.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>Schlitze %1 bis %2 haben ein Spiel von %3 bis %4 mm: den Streifen hineinstecken und dem Material das Spiel des Schlitzes geben, der passt.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>Kein Platz für die An- und Auslaufwege aller Schnitte: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>Über FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Lizenzen</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Für Fehlerberichte</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Flache Teile in 3D zeichnen, sofort sehen, wie sie passen, und sie schneiden. Ohne Konto, und nichts verlässt diesen Rechner.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Nach „FlatFitFab: Interactive Modeling with Planar Sections“ von J. McCrae, N. Umetani und K. Singh (UIST 2014). Freie Software unter der GNU General Public License, Version 3 oder neuer.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Womit dieses Programm gebaut ist</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Text der Lizenz</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Dieses Programm</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Fenster, Dateien und Text</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Exakte Geometrie</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Vektoren und Matrizen</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Umrisse verschneiden und versetzen</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Teile, die CGAL benutzt</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Zahlen ohne Rundung</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Zahlen mit vielen Stellen</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Ergebnisse, die Fehler sein können</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Zeichnungen lesen</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Zeichnungen auspacken</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modelle mit Bildern und Netzen</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>Das Modell in Webseiten der Schritte</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>&amp;Prüfungen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>&amp;Scheibe</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>&amp;Operation</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Auf einer &amp;Ebene zeichnen</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Ansicht von</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Fe&amp;nster</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Dara&amp;uf zeichnen</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>An&amp;ordnen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Au&amp;swählen</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Werkzeugleiste zum Anpassen</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>gerade eben</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>vor %n Minute</numerusform>
            <numerusform>vor %n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>vor %n Stunde</numerusform>
            <numerusform>vor %n Stunden</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>vor %n Tag</numerusform>
            <numerusform>vor %n Tagen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Älter als die Zeichnung</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: älter als die Zeichnung</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Urteile</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Without bending</source>
        <translation>Ohne Biegung</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Hält</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>Die Scheibe ist nicht da</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>So, wie es ist, steht es nicht</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Festigkeit unbekannt</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>läuft… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>läuft …</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>nicht berechenbar</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>Es bricht so, wie es ist</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Zahlen des Zeichenwerkzeugs</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Heraus</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopien</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Älter als die Zeichnung</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckWords</name>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Tips only past 12°.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>Die Prüfungen beginnen mit der ersten Scheibe.</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Älter als die Zeichnung</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Noch gibt es keine Scheibe zu prüfen.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Problem %1 von %2: %3.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1 an %n Stelle</numerusform>
            <numerusform>%1 an %n Stellen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Es gibt kein Problem.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Wird noch geprüft; bisher kein Problem.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Es wird noch geprüft. Es geschieht, sobald das bekannt ist.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>Das Modell hat sich geändert; das geht nicht mehr.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Mit einem Klick: %1.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Erledigt: %1.</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>Problem %1 von %2, Stelle %3 von %4: %5.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>Exportieren nach</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Eintippen, was geschehen soll</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Passende Befehle</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Kein passender Befehl</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Ein anderes Wort dafür versuchen</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Passprobe schreiben</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 Passprobe</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Passprobe in %1 geschrieben. Schneide sie und stecke den Streifen in ihre Schlitze; beim Export wählst du, welcher passt.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: ohne Spiel</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: %2 schmaler</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: %2 breiter</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Stege</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>So viele kurze Lücken im Schnitt jedes Teils halten es in seiner Platte; 0: keine</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Breite der Stege</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Jeder Schnitt beginnt und endet so weit neben seiner Linie, im Abfall; 0: auf der Linie</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>nur einmal schneiden</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Gemeinsame Kanten</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>Von Teilen, die aneinander liegen, wo der Abstand 0 ist</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Welcher der nummerierten Schlitze einer Passprobe die Platte am besten hält (zu schneiden aus dem Menü Datei oder aus den Dateien für die Werkstatt). Er setzt das Spiel.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Schlitz, der passt</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>etwa %n min</numerusform>
            <numerusform>etwa %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Maß %1</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Dieses Maß löschen</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>Eine andere Länge hier skaliert das ganze Modell</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Eine andere Länge streckt %1 zwischen den beiden Stellen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Ein Modell öffnen</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Das Modell speichern</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Die Änderungen in %1 speichern?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Nicht speichern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>In %1 gespeichert.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Zum Gespeicherten zurück</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 ist, wie es gespeichert war. Rückgängig bringt die Änderungen wieder.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Andere Datei wählen</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 wird gespeichert …</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Anderswo speichern …</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Auf dem Datenträger geändert</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Ein Modell einfügen</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>Nichts eingefügt: %1 hat keine Scheiben.</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Zeichnung einlesen</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>Überschreiben verlöre diese Änderungen.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Vorlage hinzufügen</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Lokale Symmetrie</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Wie lange die Ansicht braucht, um sich zur Ebene einer neuen Scheibe zu drehen</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Eine Kontur an ihrem Schlitz spiegeln, wenn sie auf einer Seite davon gezeichnet wird. Umschalt kehrt das beim Zeichnen um.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Erste spiegeln</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Auch die erste Scheibe spiegeln, an der Senkrechten durch ihren Anfang</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>Am Boden gerade</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Am Boden gerade abschneiden: Was darunter gezeichnet ist, fällt weg</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>An Punkten, Hilfslinien, Boden und Raster einrasten</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Ansicht dreht um</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>Bei 90° blickt man gerade auf die neue Ebene; mit weniger bleibt die Scheibe zu sehen, auf der man begonnen hat</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Drehdauer</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingPage</name>
    <message>
        <source>New section, while you draw it</source>
        <translation>Neue Scheibe, während sie gezeichnet wird</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Schlitz</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>Eigener Schlitz</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Kurvenstücke</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>nach oben offen, %1 tief</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>nach unten offen, %1 tief</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>zur Seite offen, %1 tief</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Neue Scheibe</translation>
    </message>
    <message>
        <source>A hole, while you draw it</source>
        <translation>Ein Loch, während es gezeichnet wird</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Eine neue Kontur, während sie gezeichnet wird</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Nicht gespiegelt.&lt;/b&gt; Die beiden Hälften träfen sich am Schlitz nicht.</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>Als Nächstes kommt die Kontur</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Nicht gespiegelt.&lt;/b&gt; Auf einer Seite der Achse gezeichnet: %1 auf der einen, %2 auf der anderen Seite. Symmetrie ist aus, oder Umschalt ist gedrückt.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;Gespiegelt.&lt;/b&gt; Auf einer Seite der Achse gezeichnet: %1 auf der einen, %2 auf der anderen Seite. Wer sie um %3 oder mehr überquert, zeichnet beide Seiten selbst.</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Auf der Führung</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1 % des Strichs</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Am weitesten ab</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Immer nur eine Zahl auf einmal kann einem Wert folgen.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Diese Zahl kann keinem Wert folgen.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Keine. Eine Scheibe anklicken, um sie auszulassen oder zu lösen.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Wieder zeigen</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, ausgelassen</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1, gelöst</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>Schneiddateien exportieren</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Danach den Ordner öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 als Körper</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 auf %2 · %3 Schnitt</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Haut über %1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Wird ausgelegt…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 und weitere in %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Ersetzt %1 in %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>dem Benutzerordner</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Platte %1 von %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Teileliste</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Vorige Platte (Bild auf)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Nächste Platte (Bild ab)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>Die ganze Platte zeigen</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Platte %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Es gibt nichts zu schneiden.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>Körper haben keine Platten: Die Datei enthält das Modell, wie es steht, in wahrer Größe, mit seinen Schlitzen.</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Eine Haut hat keine Platten: Die Datei enthält die Form, die die Scheiben andeuten, als Fläche über ihren Konturen.</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Genutzt: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Teile werden auf Platten gelegt…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>Welches Material?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Gemessene Dicke</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>Welche Platte?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Breite der Platte</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Höhe der Platte</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, %2 dick</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Eigenes Maß</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Die Platte, die geschnitten wird, mit dem Messschieber messen: Die Schlitze werden dafür gezeichnet.</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>Welche Maschine?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Farben, Ebenen, Geschwindigkeiten und G-Code, wie diese Maschine und ihr Programm sie nehmen, und was sie von jedem Material wegnimmt</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, gemessen %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>Das habe ich gemessen</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>%n Reststück wird zuerst verbraucht.</numerusform>
            <numerusform>%n Reststücke werden zuerst verbraucht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Irgendein Laser</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Kein Teil liegt auf einem Reststück.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>%1 von %n Reststück zuerst verbraucht.</numerusform>
            <numerusform>%1 von %n Reststücken zuerst verbraucht.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2-mal</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>Nicht zu schneiden</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Nichts zu beachten.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Eine Platte aus %1 hat innerhalb der Ränder von %2 keinen Platz.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>Die Schnittfuge von %1 ist 0: Schlitze werden weiter und Teile kleiner, um so viel, wie die Maschine wegnimmt.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>Die Platten sind größer als das Bett von %1 mit %2. Kleinere wählen.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Passung</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Schnittfuge (ganz)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Schlitzspiel</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Schlitz gezeichnet</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Rand der Platte</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm, unter den Platten</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Vierteldrehungen</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Vierteldrehungen bei Platten mit Maserung</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Messbalken</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Neben die Platten gezeichnet, nicht geschnitten: An der Maschine nachmessen, um der Größe sicher zu sein</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Halbe Drehungen</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Wie gezeichnet</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Wird für dieses Material und die gewählte Maschine behalten</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>eine Farbe je Verbindung</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Verbindungsnummern</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>Beide Teile einer Verbindung tragen ihre Nummer in derselben Farbe: für Papier und für Maschinen, denen man je Farbe sagt, was zu tun ist</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>Unsicher? Zuerst eine Passprobe schneiden…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 wird exportiert …</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n Platte</numerusform>
            <numerusform>%n Platten</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>%1 auf %2 nach %3 exportiert.</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>%1 als Körper nach %2 exportiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Anderswohin exportieren …</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 ist größer als die Platte und liegt auf einer Platte eigener Größe.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 ist zu schmal für seine Nummer.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>%1 auf %2 nach %3 exportiert; Schlitze sind %4 breit gezeichnet.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 hat keinen Platz für die Nummern aller seiner Verbindungen.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materialien …</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 hat ein Loch oder eine Kerbe, schmaler als die Schnittfuge; sie werden nicht geschnitten.</translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>Die Schlitze von %1 lassen nichts davon übrig. Es wird nicht geschnitten.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>%1 auf %2 nach %3 exportiert; Schlitze sind %4 breit gezeichnet (%5 − %6 Schnittfuge).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Platten eines früheren Exports sind noch da: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Haut nach %1 exportiert; %n Stelle bleibt offen.</numerusform>
            <numerusform>Haut nach %1 exportiert; %n Stellen bleiben offen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Haut nach %1 exportiert.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>Nicht exportiert: Die vorhandenen Dateien bleiben.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>Es braucht %n Platte aus %1 mehr, als da ist.</numerusform>
            <numerusform>Es braucht %n Platten aus %1 mehr, als da sind.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Es fehlt eine Zahl.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>„%1“ kann hier nicht gelesen werden.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Eine Klammer ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>Da ist eine schließende Klammer zu viel.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>Durch 0 kann nicht geteilt werden.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Hinter „%1“ fehlt etwas.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Keinen Wert mit Namen „%1“ gibt es.</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>Das ergibt keine Länge; eine Länge wird mit einer bloßen Zahl malgenommen.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>Das ergibt keine Masse; eine Masse wird mit einer einfachen Zahl malgenommen.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>„t“ ist die Dicke des Materials; hier gibt es nicht ein einziges.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>%1 konnte nicht geöffnet werden: Es ist nicht mehr in %2. Nichts wurde verändert.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>%1 konnte nicht geöffnet werden: %2. Nichts wurde verändert.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>%1 konnte nicht geöffnet werden: %2 (%3). Nichts wurde verändert.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>Die Datei ist noch die alte.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>den Ordner %1 gibt es nicht</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>%1 konnte nicht gespeichert werden: %2. %3</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>Nicht exportiert: %1. %2</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 ist kein Modell. FlatFitFab öffnet %2.</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>Nichts wurde geöffnet: Es war keine Datei genannt.</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Loch %1</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>Einen ihrer Punkte verschieben, dann ist sie es</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Von seiner Mitte, in den Koordinaten der Scheibe</translation>
    </message>
    <message>
        <source>Free form</source>
        <translation>Freie Form</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>Schneiddatei</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Papier oder Bild</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Körper zum Drucken oder Darstellen</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Stückliste</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Alles für eine Werkstatt</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>Welche Datei?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Wofür ist sie?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Eine Datei je Platte</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Nachzeichnen</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Liegt auf</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Auf den Boden legen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Aufstellen, von vorne zu sehen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Aufstellen, von rechts zu sehen</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Auf die ausgewählte Scheibe legen, mit der es geht</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Wie von hinten gesehen</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Zwei ausrichten</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>Die letzten zwei Bilder als Vorder- und Seitenansicht desselben Dings: gleich hoch und über derselben Stelle</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>Wie dunkel es sein muss, um nachgezeichnet zu werden</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>Wie rund Ecken werden</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Scheiben aus seinen Umrissen, auf seiner Ebene</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Löcher in der Scheibe, auf der es liegt oder die ausgewählt ist</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Linien auf der Scheibe, auf der es liegt oder die ausgewählt ist</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: zu viele für Scheiben</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Scheiben anlegen</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Löcher schneiden</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Gravieren</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>auseinandergezogen, %1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n Verbindung auseinandergezogen, bis %1&#x202f;N</numerusform>
            <numerusform>%n Verbindungen auseinandergezogen, bis %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Zeichnungen (%1)</translation>
    </message>
</context>
<context>
    <name>fff::ui::GizmoMarks</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Copy: %1</source>
        <translation>Kopie: %1</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <extracomment>the way to the right, along an arrow</extracomment>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Heraus</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>Die Tasten als Seite speichern</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>FlatFitFab-Tasten</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 konnte nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Alle Schritte; einen zu wählen führt zu ihm zurück.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Hier wird jeder Schritt stehen; zu jedem führt ein Weg zurück.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>Zurück am Anfang. Ein Klick auf einen späteren Schritt wiederholt ihn.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>Das Modell ist, wie es nach „%1“ war.</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Neues Modell</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Hier gespeichert</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Choose…</source>
        <translation>Auswählen …</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is what an operation works on (&quot;Along&quot;), %2 the name of a section</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Entf nimmt eine Scheibe heraus, Ziehen oder Alt mit Pfeiltaste ändert die Reihenfolge.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (fehlt)</translation>
    </message>
</context>
<context>
    <name>fff::ui::InstanceGroup</name>
    <message>
        <source>Made by an operation</source>
        <translation>Von einer Operation</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Kommt von</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Abbild von</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>Diese auslassen</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Gemacht aus</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>Aus dieser eine gezeichnete Scheibe machen; die anderen macht die Operation</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>Was mit einer geschieht, geschieht mit allen</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>Neu zeichnen: Alles, was daraus gemacht ist, folgt</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Schlitze</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>Öffnet</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Schlitze umdrehen</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Schlitz</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Treffpunkt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>geschlossen, %1 lang, %2 breit</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>%1 tief, %2 breit</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Treffpunkt %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Scheiben: %1 und %2</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 öffnet</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>In %1</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>An dieser Verbindung ist nichts von Hand eingestellt</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>Zapfen, %1 breit</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 kürzen</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Automatik wiederherstellen</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 und %2 durchdringen sich.</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>So viel des Weges nimmt der Schlitz von %1, der von %2 den Rest</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Von Hand eingestellt; von selbst 50&#x202f;%. %1</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Von Hand eingestellt; die Automatik lässt sich wiederherstellen</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>Wohin der Schlitz von %1 aufgeht; der von %2 geht zur anderen Seite auf</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Art, Richtung und Treffpunkte wieder dem Programm überlassen</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Select the joint with %1</source>
        <translation>Die Verbindung mit %1 wählen</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>Kreuzüberblattung</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>lange Überblattung</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>Zapfenloch</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>Kreuzüberblattung</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>Lange Überblattung</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Zapfenloch</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>Das Spiel ihres Materials lässt einem Schlitz keine Breite</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>Schlitze können nicht nach außen aufgehen: Ein Loch ist im Weg</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>Eine Scheibe reicht über die andere hinaus, in jeder Richtung</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Keine der Scheiben reicht über die andere hinaus</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Treffen sich an mehr als einer Stelle</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Nach links</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Nach vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Nach hinten</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>Eine Scheibe endet nur an der anderen</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Keine Scheibe endet an der Fläche der anderen</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Treffen sich unter weniger als 30°</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Nichts würde sie halten: Wo Schlitze beginnen würden, sind Löcher</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>Hier könnten sie nur in eine Richtung gleiten, dort nur in die andere</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Keine Scheibe passt durch einen geschlossenen Schlitz in der anderen</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>Für Zapfen und ihre Schlitze ist kein Platz</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Tasten drücken</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>Als Seite zum Drucken speichern …</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>In der Ansicht</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>Die erste Scheibe zeichnen</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>in der Mitte ziehen</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Eine Scheibe quer zu einer anderen zeichnen</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>aus ihr heraus ziehen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Die Ansicht drehen</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>neben dem Modell ziehen</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Näher herangehen</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Die Ansicht verschieben</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>mit der mittleren Taste ziehen</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Eine Gruppe auswählen</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>mit Umschalt ziehen</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Zeigen, was damit geht</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Einen Punkt hinzufügen</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>Doppelklick auf die Kontur</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Ohne Einrasten zeichnen</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>Strg halten</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Teile in Löchern</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>Kleine Teile dürfen in den Löchern großer liegen</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
</context>
<context>
    <name>fff::ui::LibraryDock</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Auswahl aufnehmen</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner …</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>Den Ordner wählen, dessen Modelle hier stehen</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>Hier erscheint, was aufgehoben wird: Scheiben wählen, dann „Auswahl aufnehmen“ anklicken.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>Nichts aufgenommen: Noch ist nichts gezeichnet.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 ist nun in der Bibliothek.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Zum Modell hinzufügen</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>Die Auswahl in die Bibliothek aufnehmen; ohne Auswahl das Modell</translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Der Ordner der Bibliothek</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>Der Ordner der Bibliothek, %1, lässt sich nicht anlegen.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 ist im Papierkorb.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>%1 ließ sich nicht in den Papierkorb legen.</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>In den Papierkorb legen</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadPage</name>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Wo es wirkt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Nur ein Gewicht</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>Auch in kg, oz oder lb: 1,5 kg, 2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Wasser darin</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N ist ungefähr, was 1 kg wiegt</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Richtung X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Richtung Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Richtung Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>In der Ebene der Scheibe, von deren Ursprung aus</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Stelle X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Stelle Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Verteilt</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>An einem Punkt</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>Auf einer Fläche</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Auf dem Rand</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Hängend</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Kopien, die Operationen von seiner Scheibe machen, tragen je eines</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>So weit über seiner Stelle: je höher, desto eher kippt alles</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>Auch auf Kopien</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Gewichte und Kräfte</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 benennt um, Entf entfernt.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Kräfte</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
</context>
<context>
    <name>fff::ui::MagnetGroup</name>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Herangezogen</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Biegt die Vorlage in die Ebene dieser Scheibe, damit Führungen der anderen dem Gezeichneten folgen</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>Aus höchstens</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Scheiben wiederholen und ineinander übergehen lassen</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>Das Modell kann nicht gezeigt werden: Der Grafiktreiber bietet kein OpenGL 3.3. Ein neuerer Treiber kann helfen.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>Auf dieser Anzeige kann das Modell nicht gezeigt werden.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Gerettet: %n ungespeichertes Modell</numerusform>
            <numerusform>Gerettet: %n ungespeicherte Modelle</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Ordner anzeigen</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Ein eigenes Modell beginnen, an einem weiterarbeiten oder ein Beispiel ansehen.</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Dieses Modell ist zum Anpassen da. „Entwurf bearbeiten“ holt alles zurück.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Hilfe: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Scheiben vorschlagen</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Wie viele</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Findet Scheiben, die seine Form zeigen, einander halten und stehen</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Noch eine</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Eine Scheibe, die zwischen die vorhandenen passt</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>Andere Scheiben statt der letzten</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Aus Flächen bauen</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>Baut es aus flachen Scheiben mit Fingerzinken an den Kanten. Das Netz wird erst auf so viele Flächen vereinfacht; die in einer Ebene werden eine Scheibe.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Abwickeln</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>Legt es flach aus, um es aus Karton in einem Stück oder wenigen zu schneiden und entlang geritzter Linien zu falten. Kanten, die zusammenkommen, haben dieselbe Nummer.</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Markierung %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Graviert</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Geritzt</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Diese Markierung löschen</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Buchstabenhöhe</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
</context>
<context>
    <name>fff::ui::MassEdit</name>
    <message>
        <source>g</source>
        <translation>g</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureMarks</name>
    <message>
        <source>%1   X %2  Y %3  Z %4</source>
        <extracomment>a length, and how far it goes along X, Y and Z</extracomment>
        <translation>%1   X %2  Y %3  Z %4</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureText</name>
    <message>
        <source>%1&#x202f;kg</source>
        <translation>%1&#x202f;kg</translation>
    </message>
    <message>
        <source>%1&#x202f;g</source>
        <translation>%1&#x202f;g</translation>
    </message>
    <message>
        <source>%1&#x202f;in²</source>
        <translation>%1&#x202f;in²</translation>
    </message>
    <message>
        <source>%1&#x202f;cm²</source>
        <translation>%1&#x202f;cm²</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeshImport</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 kennt keine Einheit und wurde %2 groß gemacht. Die Größe steht unter Vorlagen.</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 ist zu groß für ein Modell und wurde daher %2 groß gemacht. Die Größe steht unter Vorlagen.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Netze, Bilder und Zeichnungen (%1)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Eingefügtes Bild</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>Im Maßstab von %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weitere.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>noch nichts gezeichnet</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Neue Scheiben</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Material der Scheiben, die als nächste gezeichnet werden</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Material bearbeiten</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>Zeigt übertrieben, wo sich das Modell biegt oder löst. Es wird nichts verändert.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>Bewegungen sind reduziert: den Regler benutzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Gezeigt wird, wie es anfängt, sich zu lösen.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Biegt sich um %1.</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>Wie es sich bewegt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>„Biegsam“ einschalten, um die Biegung zu sehen.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Biegt sich um %1, %2-fach gezeigt.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Ein Name ist ein Wort aus Buchstaben und Ziffern, außer „t“ und den Einheiten.</translation>
    </message>
    <message>
        <source>Named values</source>
        <translation>Benannte Werte</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Diesen Wert löschen</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Scheibe %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>Mindestens %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>Höchstens %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Reststück</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Eine Platte anderer Größe, die vor ganzen aufgebraucht wird</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>Aus einer Zeichnung …</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>Was von einer Platte übrig ist, als größter Umriss einer SVG-Datei in wahrer Größe, mit seinen Löchern</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Breite des Reststücks</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Höhe des Reststücks</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Wie viele von diesem Reststück</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Dieses Reststück wegnehmen</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, aus einer Zeichnung</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationMarks</name>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a number (&quot;From&quot;), %2 its value</extracomment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationNotices</name>
    <message>
        <source>Choose another</source>
        <translation>Andere auswählen</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Mehr erlauben</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Ausnahmen</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Umwandeln</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Mehr erlauben</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Aus dem, was sie macht, gezeichnete Scheiben machen; die Operation gibt es dann nicht mehr</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>Löschen, mit allem, was daraus gemacht ist</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Operationen, der Reihe nach</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 benennt um, Leertaste blendet aus und ein, Alt mit Pfeiltaste ändert die Reihenfolge.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Ausgeblendet: einblenden</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ausblenden</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Gliederung</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Nach Name oder Material filtern</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>Hier erscheinen die Scheiben, sobald sie gezeichnet sind.</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, wird gezeichnet</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 benennt um, Leertaste blendet aus und ein.</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Ausgeblendet: einblenden</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Gesperrt: entsperren</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Hier mit gedrückter linker Taste eine Form zeichnen.</translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Schlitze werden berechnet …</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Schlitz %1</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>Am Schlitz gespiegelt</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>An der Senkrechten gespiegelt</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Am Boden eben abgeschnitten</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 vom letzten Punkt</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Schlitz %1, %2</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, und noch %n hier</numerusform>
            <numerusform>%1, und noch %n hier</numerusform>
        </translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Boden %1 unter diesem Rand</translation>
    </message>
</context>
<context>
    <name>fff::ui::ParameterRow</name>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>As it follows from the sections</source>
        <translation>Wie es aus den Scheiben folgt</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Von Hand gesetzt</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Teileliste</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>Physik</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Spannungslinien</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Schwächste Stellen</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Eigengewicht</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Auf dem Boden</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Gewicht setzen</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Wie streng</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Sicherheitsfaktor</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Dieses Gewicht entfernen</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Ob es hält, konnte nicht ermittelt werden.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Älter als die Zeichnung, wird ermittelt …</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Es steht nicht; Spannungen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Eine Verbindung wird auseinandergezogen; Spannungen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Festigkeit unbekannt: Für ein Material ist keine eingetragen. Trag sie unter Materialien ein.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>Aktuell. Alle Kräfte sind im Gleichgewicht.</translation>
    </message>
    <message>
        <source>%1, %2: %3&#x202f;%</source>
        <extracomment>the name of a section, a place in it such as &quot;at its neck&quot;, a number of percent</extracomment>
        <translation>%1, %2: %3&#x202f;%</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Druck hinzufügen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>what a weight or a push is called, and the section that it is on
----------
the name of a section, and a place in it such as &quot;at its neck&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Remove this push</source>
        <translation>Diesen Druck entfernen</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>finite Elemente</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Biegsam</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>läuft… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>läuft …</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>nicht berechenbar</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Zeigen ab</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Kerbfaktor, höchstens</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>für Monate</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>Last bleibt</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>die ausgewählte Scheibe</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Biegt sich um %2.</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>eine Scheibe auswählen</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Anteil an der Festigkeit der Platte; weniger wird nicht gezeigt</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Wo Verbindungen sich teilen, was sie tragen, entscheidet die Steifigkeit der Scheiben, welche wie viel trägt. Dauert eine Weile.</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Festigkeitskarte</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Färbt die ausgewählte Scheibe danach, welche Masse sie an jeder Stelle trägt, zusätzlich zu dem, was schon auf dem Modell ist. Dauert eine Weile.</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Ein Gewicht auf das Modell setzen, um zu sehen, was es trägt.</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>So viel mal so viel, wie da ist, muss es tragen, damit es hält</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>Um wie viel die Spannung an Innenecken steigt, folgt aus der Länge der Engstelle, bis zu diesem Wert; rund endende Schlitze brauchen weniger</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Dann trägt ein Material weniger, so viel wie es selbst angibt: Acryl ein Viertel</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Eine Scheibe zeichnen, um zu sehen, was sie trägt.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>Aktuell. Verbindungen können sich die Last auf viele Arten teilen; die ungünstigste zählt.</translation>
    </message>
</context>
<context>
    <name>fff::ui::PlaceGroup</name>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Winkel dazu</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X der Mitte</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y der Mitte</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z der Mitte</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X der Richtung, in die sie zeigt, Länge 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y der Richtung, in die sie zeigt, Länge 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z der Richtung, in die sie zeigt, Länge 1</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>Geht weder mit der Scheibe mit, auf der sie sitzt, noch behält sie ihren Winkel zu dieser</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Bleibt, wie sie ist, außer wenn die Scheibe bewegt wird, auf der sie sitzt</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>Was mit Punkten der einen Hälfte geschieht, geschieht auch mit denen der anderen</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Eine andere Scheibe anklicken, auf die sie gesetzt werden soll</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>Auf keiner anderen Scheibe</translation>
    </message>
    <message>
        <source>across its slit</source>
        <translation>an ihrem Schlitz</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>an der Senkrechten</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>an der Waagerechten</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>im Verhältnis</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>dem linken Ende</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>dem rechten Ende</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>dem unteren Ende</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>dem oberen Ende</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Wie ihr Platz folgt, wenn ein Wert die Scheibe streckt, auf der sie sitzt: so weit, wie jene dort gestreckt wird, oder in ihrem Abstand zu einem Ende</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>Griff davor</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Winkel davor</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Griff danach</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Winkel danach</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>geändert</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Vorgabe</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, vier Böden …</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Was jetzt gesetzt ist, als Vorgabe behalten</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Diese Vorgabe löschen</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Als Vorgabe behalten</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Gibt dem, was jetzt gesetzt ist, einen Namen, etwa A5, um darauf zurückzukommen</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 außerhalb</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 innerhalb</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 zu hoch</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>%n weiteres unter Prüfungen.</numerusform>
            <numerusform>%n weitere unter Prüfungen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nichts ist gewählt</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Scheibe · %1</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n Verbindung</numerusform>
            <numerusform>%n Verbindungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Änderungen gelten für alle</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Scheibe · auf %1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>joint</comment>
        <extracomment>the names of two sections that meet</extracomment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automatisch</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · von Hand</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Von %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · ausgeschaltet</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · macht nichts</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · aktuell</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is a mass or a force, %2 the name of a section</extracomment>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Ausgeschaltet macht sie nichts und behält alles, was eingestellt ist</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Durchdringen sich</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zu&amp;letzt benutzt</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Diese Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Diese Namen vergessen; die Dateien bleiben</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>Was zu beachten ist</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Schließt dies und wählt es im Modell aus</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Dateien ersetzen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>%n vorhandene Datei ersetzen?</numerusform>
            <numerusform>%n vorhandene Dateien ersetzen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>Diese Datei ersetzen?</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>längs</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>An einer Rippe entlang, von Ring zu Ring</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>An einer Rippe entlang bis zum unteren Ring</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>versatz</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>achse_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>achse_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rücken</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Querbalken</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Querbalken</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>Bauchrippe</translation>
    </message>
    <message>
        <source>between</source>
        <translation>dazwischen</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Brett</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Bretter</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>bretter</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>großbuchstabe</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>column</source>
        <translation>spalte</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>spalten</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Lagerbock</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>lagerbock</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Krone</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Besteck</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>tiefe</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>durchmesser</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>abstand</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Trennwand</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Trennwände</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Ohren</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Hinterer Sockel</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Hinterer Tänzer</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Hinterer Tänzer, geneigt</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Hintere Tänzer</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Tanne</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Tanne quer</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Vorderbeine</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Gabeln und Teelöffel</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Vier Bretter</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>Von Achse zu Achse, waagrecht</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>Von Achse zu Achse, mit etwas Spiel</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>Von Wand zu Wand</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Vorderer Fuß</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Vorderbeine</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Vordere Zarge</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Vordere Welle</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Glas Wasser</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>height</source>
        <translation>höhe</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Höhe der Großbuchstaben; ein langer Name muss kleiner sein</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Höhe der Lagerböcke</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Höhe der Ritzelachse</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Höhe der Radachse</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Hinterer Fuß</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Hinterbeine</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Hintere Welle</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Hüfte</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Geweih</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>Wie weit eine Rippe am oberen Ring neben ihrem Platz unten sitzt</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>Wie weit sich jede Rippe neigt</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>Wie viel tiefer das Ritzel liegt, vom Rad aus gesehen</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Wie breit das Schild ist, in Höhen eines Großbuchstabens</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Seine Breite</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Gewürzgläser</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Letzte Rippe</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Linker Fuß</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Linkes Blatt</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Linke Seite</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Linke Leiste</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Linker Flügel</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Beine</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>beine</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>schrift</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Langer Fuß</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Unterer Ring</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Untere Leiste</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Mittlerer Sockel</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Mittlerer Tänzer</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Mittlerer Tänzer, geneigt</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Mittlere Tänzer</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Mittlere Rippe</translation>
    </message>
    <message>
        <source>module</source>
        <translation>modul</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Becher</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Schnauze</translation>
    </message>
    <message>
        <source>name</source>
        <translation>name</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Namensschild</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Vorderer Sockel</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Vorderer Tänzer</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Vorderer Tänzer, geneigt</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Vordere Tänzer</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>Einer Rippe, an ihr entlang</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>Der Bretter, von Ende zu Ende</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Der Schublade, innen</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Des Glases</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>Der höchsten Wand</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Des Ritzels, von einer Lücke zum Rad hin</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Des Ritzels, ebenso</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>Der Seiten</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>Der Seiten; die Krone ragt darüber hinaus</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>Des Rads</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>Des Rads, bis zum Grund seiner Zahnlücken</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>Des Rads, bis zu den Spitzen seiner Zähne</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Anderer Fuß</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Anderer Pfeiler</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Anderer Handlauf</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Andere Schwelle</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Andere Zehe</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Stifte</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>phase</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>Pfeiler</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Ritzel</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>ritzel</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Ritzelzähne</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>ritzel_radius</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>ritzel_fuß</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>ritzel_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Rückenplatte</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>schild</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Rückenplatten</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>radius</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Handlauf</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Flossenstrahl</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Flossenstrahlen</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Hintere Rippe</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>rest</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Rippe</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Rippen</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>rippen</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Rechter Fuß</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Rechtes Blatt</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Rechte Seite</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Rechte Leiste</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Rechter Flügel</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Lochkranz</translation>
    </message>
    <message>
        <source>root</source>
        <translation>fuß</translation>
    </message>
    <message>
        <source>row</source>
        <translation>reihe</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>reihen</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Schrauben</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Ablage</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Größe der Zähne: Durchmesser geteilt durch ihre Anzahl</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Kleines Glas</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Rückgrat</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Löffel und Messer</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zähne</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>zähne</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Zähne des Ritzels</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>Dasselbe ohne ganze Zähne</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Drei Bretter</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>neigung</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Spant</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>Spanten</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>Zehe</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Stamm</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>Wasserglas</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehung</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Zweig</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>drall</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Oberer Ring</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Obere Leiste</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Halswirbel</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Schwanzwirbel</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Wal</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>Wofür die Platte Platz hat</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Wo ein Zahn des Rads steht</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Breit</translation>
    </message>
    <message>
        <source>width</source>
        <translation>breite</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>breiten</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Fisch</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Dackel</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Tanne</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Lampenschirm</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Puppenstuhl</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Glashalter</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Schreibtischbox</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Fischgräten</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinosaurier</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Hirschkäfer</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Wachsender Baum</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Tänzer in zwei Haltungen</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Zahnräder</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Wal aus Zellen</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Besteckmann</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Glas auf drei Beinen</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Drei dünne Beine: zu schwach</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Vier dünne Beine: zu schwach</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Drei dicke Beine: knapp</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Vier dicke Beine: sicher</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Bär über einem Netz</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Eule nach Bildern</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Igel in Schnitten</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Regal</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Schubladeneinsatz</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Namensschild</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Glasständer</translation>
    </message>
</context>
<context>
    <name>fff::ui::ScaleBar</name>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
</context>
<context>
    <name>fff::ui::SearchWords</name>
    <message>
        <source>begin create empty blank</source>
        <translation>anfangen erstellen leer beginnen</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>laden importieren flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>hinzufügen zusammenführen anhängen</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>sichern schreiben</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>kopieren umbenennen</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>neu laden verwerfen</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>drucken laser lasern schneiden cnc plotter svg dxf pdf gcode lightburn herstellen fertigen</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>optionen konfigurieren dunkel hell farben sprache einheiten zoll maus navigation sicherung animation</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>tasten tastatur hotkeys kürzel</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>verlassen schließen</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf importieren</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf importieren gravieren</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj bild foto abpausen durchzeichnen hintergrund</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>nochmal vor</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>zwischenablage</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>kopieren klonen</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>umdrehen symmetrisch klappen</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>entfernen weg papierkorb</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>suche finden</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoom zentrieren mitte</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>draufsicht gerade</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>orthografisch isometrisch parallel kamera</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>durchsichtig transparent drahtmodell</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>schnitt innen hälfte</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>oberfläche hülle</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>allein einzeln</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>einblenden sichtbar</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>unsichtbar</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>raster boden</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>maximieren</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>seitenleisten</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>anordnung standard</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>spiegeln hälfte</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>füße standfläche</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>magnet ausrichten fangen</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>polygon linie kurve bezier pfad</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>kreis quadrat rechteck polygon stern</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>gravieren text buchstaben beschriften</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>verschieben drehen skalieren größe</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>öffnung fenster ausschnitt</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>ersetzen</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>muster wiederholen reihe rippen</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>drehen herum</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>übergang dazwischen</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>baum gabel</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>waffel gitter raster</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>speichen rad zahnrad</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>drehen muster</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>muster wiederholen kopien</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>waffel schichten stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>umwandeln auflösen anwenden</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>fehler warnung</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>zusammenbau anleitung animation abspielen</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>festigkeit brechen simulation physik fem</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>last masse kraft</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>kraft last</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>material dicke sperrholz acryl schnittbreite</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>verschachteln anordnen</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>länge abstand größe maß</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>skalieren größe</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>handbuch anleitung dokumentation einführung</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>willkommen beispiele</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>version lizenz</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>teststück schnittbreite spiel schlitze kamm passprobe</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>teilen geben freigeben anpassen konfigurieren schüler klasse regler gesperrt vorlage customizer</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Material bearbeiten</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Die des Materials: Alle Scheiben daraus folgen</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Wie alle anderen</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Wie ihre Teile auf der Platte gedreht werden dürfen: Was sich an die Maserung hält, liegt wie gezeichnet oder um halbe Drehungen</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Eine andere Länge streckt die Kontur um ihren Schlitz oder ihre Mitte</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>fff::ui::SegmentedBox</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is the name of a choice (&quot;Side&quot;), %2 one of what can be chosen (&quot;Both&quot;)</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Gruppen von Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Tastatur</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimeter (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Zentimeter (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Zoll (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>So wird angezeigt und eingegeben. Dateien enthalten immer Millimeter.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Wie lange sich die Ansicht beim Zeichnen zur neuen Ebene dreht. Mit 0 springt sie.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Immer</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>So wenig wie möglich</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Bei „so wenig wie möglich“ springt die Ansicht, statt sich zu drehen.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Welche Tasten die Ansicht drehen, verschieben und zoomen. Strg mit der linken Taste dreht immer, Leertaste mit der linken verschiebt.</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Je flacher sich zwei Scheiben treffen, desto breiter müssen ihre Schlitze sein.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Reihenfolge für den Zusammenbau suchen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Gilt nach einem Neustart.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Beim Start die Startseite zeigen</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Drehdauer</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Ansicht dreht um</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>Bei 90° blickt man gerade auf die neue Ebene. Mit weniger bleibt die Scheibe zu sehen, auf der man begonnen hat.</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Maustasten wie in</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Spannungsfarben für Farbenblinde</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>Von hell nach dunkel statt von Blau nach Rot. Bei hohem Kontrast immer.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Warnen bei Winkeln unter</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Ein kleineres Überlappen ist kein Problem.</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>Im Hintergrund, nach jeder Änderung. Mehr Zeit hilft, wenn die Prüfungen sagen, dass sie keine Reihenfolge gefunden haben.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Sicherheitsfaktor</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Kerbfaktor, höchstens</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>So viele Male höher gilt die Spannung an inneren Ecken.</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Ungespeichertes sichern alle</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Nach einem Absturz oder Stromausfall ist es wieder da, auch nie Gespeichertes. Die Datei bleibt unberührt.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Beim Speichern die vorige Fassung der Datei behalten</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>So viele Male muss ein Modell seine Last tragen, damit es als fest genug gilt.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Überlappung zählt erst ab</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>Striche folgen einer Vorlage bis auf</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>Lasten wirken monatelang</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Einfaches Fenster</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Zum Zeichnen, Prüfen und Exportieren; alles andere ist aus dem Weg.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Sheet</name>
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
        <source>K40 laser</source>
        <translation>K40-Laser</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>Ganze Sperrholzplatte</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>Auf der Platte</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Lage X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>behält seinen Platz</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Angeheftet</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P heftet das gewählte Teil bei den Platten an oder löst es</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>zu groß für eine</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, ihr erstes Teil</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm, zum Prüfen der Größe</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Platte, wie sie geschnitten wird</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Plus und Minus zoomen, die Pfeiltasten verschieben sie, Pos1 zeigt die ganze.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>Reststück %1 bleibt ganz</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Platten</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Am besten</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Wie gut die Teile ausgelegt werden</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Schnell legt alle Teile neu aus. Gut dauert etwa zehn Sekunden. Am besten sucht weiter, bis du anhältst.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Mit Raster teilen</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Zeichne eine Scheibe, und sie liegt hier, fertig zum Schneiden.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Wird ausgelegt…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Wird neu ausgelegt…</translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 ist zu groß für die Platte.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 und %n weitere Scheibe sind zu groß für ihre Platten.</numerusform>
            <numerusform>%1 und %n weitere Scheiben sind zu groß für ihre Platten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Alle lösen</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n angeheftetes Teil hatte an seiner Stelle keinen Platz.</numerusform>
            <numerusform>%n angeheftete Teile hatten an ihren Stellen keinen Platz.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Reststück hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n Platte mehr, als da ist</numerusform>
            <numerusform>%n Platten mehr, als da sind</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · %2 Schnitt</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>behält das Beste bisher, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Wird ausgelegt… %1 % genutzt</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 auf %2 · %3 % genutzt · %4 Schnitt</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Platten, wie sie geschnitten werden</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · um %4° gedreht</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Platte %1 von %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>Zu groß</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>Faser ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n Teil · %1 % belegt</numerusform>
            <numerusform> · %n Teile · %1 % belegt</numerusform>
        </translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Bild auf und Bild ab gehen von Teil zu Teil, die Pfeiltasten verschieben ein Teil um 1 mm, R dreht es, P heftet es an. Plus und Minus vergrößern und verkleinern, Pos1 zeigt alle Platten.</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>Dafür ist kein Platz.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>So wenig darf es nicht gedreht werden.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Es liegt wie gezeichnet.</translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Reststück, Platte %1 von %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Angeheftet: bleibt, wo es liegt. Klicken löst es.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Ein Teil an eine andere Stelle ziehen oder zum Auswählen anklicken.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Klicken löst &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; ist zu groß für seine Platte. Klicken wählt es aus.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; an eine andere Stelle ziehen oder zum Auswählen anklicken.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; an eine andere Stelle ziehen. &lt;kbd&gt;R&lt;/kbd&gt; dreht es, &lt;kbd&gt;P&lt;/kbd&gt; heftet es an.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Nach Name oder Tasten filtern</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>Hier verwenden</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Wirkt</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>in der Ansicht</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Tasten für %1:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Selbst geändert</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 gehört zu „%2“.</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Keine Tasten für diesen Befehl</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>Die ursprünglichen Tasten dieses Befehls</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>Die ursprünglichen Tasten aller Befehle</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Befehl wählen</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 allein stünde dem Tippen im Weg. Mit Strg oder Alt halten; einzelne Tasten sind für Befehle, die in der Ansicht wirken.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Haut: läuft … %1&#x202f;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Haut: läuft …</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Haut: angehalten</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Haut: ließ sich nicht berechnen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Haut: keine Konturen kreuzen sich</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Klicken hält an.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Eine Haut braucht Scheiben, die sich kreuzen und dort an derselben Stelle enden.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n Flächenstück</numerusform>
            <numerusform>%n Flächenstücke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; %n Stelle bleibt offen.</numerusform>
            <numerusform>%1; %n Stellen bleiben offen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Klicken zeigt wieder die Scheiben allein.</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Haut: nichts zu überdecken</translation>
    </message>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Zwischen %1 würde sie sich weit hinauswölben: eine Scheibe quer dazu sagt, wie weit.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Zwischen %1 würde sie sich über sich selbst falten.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Was zwischen %1 ist, sagen die Konturen nicht.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Eckig</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Dogbone</source>
        <translation>Dogbone</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>T-Bone</translation>
    </message>
    <message>
        <source>Slit end</source>
        <translation>Schlitzende</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Durchmesser des Fräsers. Die Bögen werden etwas größer gezeichnet, damit er sie abfahren kann.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Ein eckiges Ende hat kein Werkzeug. Für eine Fräse ein anderes Schlitzende wählen.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Einführfase</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Klemmnoppen</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Höhe einer kleinen Noppe an jeder Wand eines Schlitzes, die auf die Scheibe darin drückt. Sie muss mehr als das halbe Spiel betragen; 0: keine.</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>Das innere Ende eines Schlitzes. Ein Laser schneidet es eckig; das runde Werkzeug einer Fräse lässt die Ecken stehen. Rund: ein runder Grund jenseits des eckigen. Dogbone: ein Bogen durch jede Ecke. T-Bone: ein Bogen in jeder Wand; der Grund bleibt eben.</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Fase beider Wände an der Mündung eines Schlitzes, unter 45°, damit Scheiben hineinfinden. Üblich ist die halbe bis ganze Dicke; 0: keine.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>erzeugte Scheibe</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>hat ein Problem</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>kein Problem</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Verbindung von %1 und %2</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, Operation</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n Scheibe gewählt</numerusform>
            <numerusform>%n Scheiben gewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 auf %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Ein eigenes Modell zeichnen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Kein Konto, nichts verlässt diesen Rechner.</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Aus dieser Liste nehmen</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>Als Kopie öffnen</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Ordner anzeigen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Ein Modell öffnen, auch eines von FlatFab</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Beim Start zeigen</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Dein erstes Modell in 3 Minuten</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Ein Modell zeichnen, prüfen und ausschneiden, Schritt für Schritt</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>Was die nächste Geste tut</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Anzahl der Scheiben</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Größe des Modells</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Masse des Modells</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Einheit aller Längen</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>„%1“ zurückgenommen.</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>„%1“ zurückgenommen. &lt;kbd&gt;%2&lt;/kbd&gt; bringt es wieder.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>„%1“ wiederholt.</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>„%1“ wiederholt. &lt;kbd&gt;%2&lt;/kbd&gt; nimmt es zurück.</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Schritte des Zusammenbaus</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Schritte exportieren …</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Schritte schließen (Esc)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Nächster Schritt (Rechts)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Voriger Schritt (Links)</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>Die Teile auseinanderziehen</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Auseinander</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Alle Schritte als PDF zum Drucken schreiben, als Webseite fürs Telefon, oder ein Bild für jeden</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Alle Schritte, zum Drucken (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Bilder, eines für jeden Schritt (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Schritte exportieren</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 wird exportiert …</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>Die Schritte konnten nicht exportiert werden: auf dieser Anzeige entsteht kein Bild.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>%1 nach %2 exportiert.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>%1 nach %2 … %3 ausgegeben.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Anderswohin exportieren …</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>Nichts geschrieben: die Ausgabe wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>Dieser Browser zeigt das Modell nicht in 3D. Hier steht Schritt für Schritt, was zu tun ist.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>Bilder fehlen: auf der Anzeige des Computers, der diese Seite geschrieben hat, entstand keines.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Ziehen dreht das Modell, zwei Finger oder das Rad vergrößern es, zweimal tippen zeigt es ganz.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Voriger Schritt</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 Teil</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 Platte</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n Platte</numerusform>
            <numerusform>%n Platten</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 Schritt</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>So wird es zusammengebaut</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, aus %2, in %3.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiteres</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>Die Nummern sind die, die auf den Teilen eingraviert sind. An jedem Schlitz steht hinter einem kurzen Strich die Nummer seiner Verbindung, auf beiden Teilen dieselbe.</translation>
    </message>
    <message>
        <source>%1, in %2.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;38 steps&quot;</extracomment>
        <translation>%1, in %2.</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsView</name>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>Die Schritte können auf dieser Anzeige nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>Die Reihenfolge wird noch bestimmt; die Schritte werden gezeigt, sobald sie bekannt ist.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Noch ist nichts da.&lt;/b&gt; Schritt 1: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1:&lt;/b&gt; %2</source>
        <extracomment>%1 is &quot;Step 4 of 38&quot;, %2 what is done in it</extracomment>
        <translation>&lt;b&gt;%1:&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>The model has changed, so its steps are not shown.</source>
        <translation>Das Modell hat sich geändert, deshalb werden seine Schritte nicht gezeigt.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>Die Schritte werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>Die Reihenfolge ist jetzt bekannt; „Schritte zeigen“ zeigt sie.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Die Schritte können nicht gezeigt werden: %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Stock</name>
    <message>
        <source>Use %1 for new sections</source>
        <translation>%1 für neue Scheiben nehmen</translation>
    </message>
    <message>
        <source>Birch plywood</source>
        <translation>Birkensperrholz</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Birkensperrholz 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Birkensperrholz 6,5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Birkensperrholz 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>Acrylglas</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>Acrylglas, klar</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Acrylglas, rot</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Wellpappe B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Wellpappe C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Wellpappe E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Karton</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Lindenholz</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM</translation>
    </message>
    <message>
        <source>Aluminium 6061</source>
        <translation>Aluminium 6061</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: %2 → %3 dick</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Material der nächsten Scheibe</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Material der nächsten Scheibe: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materialien …</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Platte B × H</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Breite der Platte</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Höhe der Platte</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Übliche Platten</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Festigkeit</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Zugfestigkeit</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Biegefestigkeit</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Schnittfuge (ganz)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Schlitzspiel</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Schlitz gezeichnet</translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>keine: Die Schnittfuge ist breiter als der Schlitz</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Dicke, Spiel und Schnittfuge zweier Scheiben dieses Materials, die rechtwinklig zueinander stehen</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>ohne Angabe</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Schlitze</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>bevor es bricht</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Biegt sich</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Wie Metall: Die Festigkeiten sind die, ab denen es verbogen bleibt</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Hält auf Dauer</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Von ihrer Festigkeit, wenn die Last bleibt: Acryl kriecht und wird rissig</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 heißt: ohne Angabe</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>Keine Scheibe ist daraus</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 heißt nicht bekannt</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Plattenpreis</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Verkauft als</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>Die Dicke, als die man die Platte kauft; meist ist sie nicht ganz so dick</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>mit dem Messschieber, von mir</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>Export fragt einmal, wie dick die Platten sind, die Sie schneiden werden</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>so viele wie nötig</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 heißt so viele wie nötig</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Wie viele da sind</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Zuerst verbraucht</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Ein Reststück aus einer Zeichnung</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Zeichnungen (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Je Maschine</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Behalten, wo eine Schnittfuge eingegeben wurde, während diese Maschine im Export gewählt war</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Größe und Anzahl</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Materialien dieses Modells</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Ein Material aus den Vorgaben hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Ein Material mit den gleichen Zahlen hinzufügen</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Das Material entfernen</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Ein Modell braucht ein Material; erst ein anderes hinzufügen</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Dieses Material entfernen</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Seine %n Scheibe wird aus</numerusform>
            <numerusform>Seine %n Scheiben werden aus</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Material %1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Material %1 entfernen</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Dieses Material in einer Datei speichern, für andere Modelle und andere Leute</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Das Material in einer Datei speichern</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei …</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Ein Material aus einer Datei hinzufügen</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>FlatFitFab-Modelle (%1)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressCard</name>
    <message>
        <source>%1&#x202f;MPa, %2&#x202f;%</source>
        <extracomment>%1 is a stress in megapascals, %2 a number of percent</extracomment>
        <translation>%1&#x202f;MPa, %2&#x202f;%</translation>
    </message>
    <message>
        <source>In the neck</source>
        <translation>An der engsten Stelle</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>An ihrer Ecke</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>In der Ebene gebogen</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Quer zur Platte gebogen</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>Längs gedrückt</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>Längs gezogen</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Abgeschert</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Verdreht</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>So schlank, dass es knicken kann, bevor es bricht.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Unsicher: Neben den Löchern, über die er geht, wirken Kräfte.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Zuerst risse es an der Ecke.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Es bräche gerade durch.</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Eine grobe Zahl: Die engste Stelle ist zu kurz oder einer Kraft zu nah.</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressMarks</name>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Nichts über %1&#x202f;%</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Festigkeit unbekannt</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>Bewegung %1&#x202f;×</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Sicherheitsfaktor %1</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Es steht nicht; Spannungen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Eine Verbindung wird auseinandergezogen; Spannungen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Ob es hält, konnte nicht ermittelt werden.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Scheiben werden gesucht…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Flächen werden gebaut…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>%1 wird nachgezeichnet …</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>%n Scheibe gemacht.</numerusform>
            <numerusform>%n Scheiben gemacht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Wird abgewickelt …</translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Wähle zuerst die Scheibe aus, in die Löcher sollen, oder lege die Zeichnung darauf.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Wähle zuerst die Scheibe aus, die graviert werden soll, oder lege die Zeichnung darauf.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Ebenen werden gesucht…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>wird jedes Mal gelesen</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>im Modell enthalten</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Datei suchen …</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Von dort lesen, wo die Datei jetzt ist; die Vorlage bleibt an ihrem Platz</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Mit Datei verknüpfen …</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>Aus der Datei des Modells weglassen, die kleiner wird, und jedes Mal von ihrem Ort lesen</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>Im Modell behalten</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>In die Datei des Modells aufnehmen, damit sie auch auf anderen Computern da ist</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>In der Ansicht bewegen, drehen und skalieren, mit Griffen oder Zahlen</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Nach einer Linie</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Eine Linie über etwas darin ziehen, dessen Länge bekannt ist</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Bewegen und drehen</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 benennt um, Leertaste blendet aus, L sperrt, Entf entfernt.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Auf den Boden</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Auf den Boden stellen</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Auf die andere Seite legen: was darin oben ist, ist auch in der Ansicht oben</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Schnitte …</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>In Scheiben schneiden, die ihm folgen</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Aufrichten</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Lage und Größe</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Vorlage hinzufügen …</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Ein Netz, ein Bild oder eine Zeichnung einlesen, um Scheiben danach zu zeichnen</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Ein Netz, ein Bild oder eine Zeichnung hinzufügen, auf das Fenster ziehen oder einfügen. Gezeichnete Scheiben rasten ein, wo ihre Ebene ein Netz schneidet, und an Linien einer Zeichnung in ihrer Ebene.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X der Mitte</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y der Mitte</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z der Mitte</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Um X gedreht, zuerst</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Um Y gedreht, nach X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Um Z gedreht, zuletzt</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Netz, %n Dreieck</numerusform>
            <numerusform>Netz, %n Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Bild, %1 × %2 Pixel</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Zeichnung, %n Linie</numerusform>
            <numerusform>Zeichnung, %n Linien</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Rundgang, Schritt %1 von %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Sieh dich um.&lt;/b&gt; Ziehe neben dem Modell, um es zu drehen; mit dem Rad kommst du näher.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Schneide es aus.&lt;/b&gt; &lt;b&gt;Export …&lt;/b&gt; zeigt die Platten und schreibt die Datei für den Cutter.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Zeichne einen Körper.&lt;/b&gt; Drücke mitten in der Ansicht und zeichne seinen Umriss in einem Zug, oben flach, bis auf den Boden.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Zeichne eine Scheibe quer dazu.&lt;/b&gt; Setze im Körper an und ziehe über seinen Rand hinaus. Halte die Taste gedrückt: Die Ansicht dreht sich. Zeichne dann den Umriss, wieder bis auf den Boden.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Miss deine Platte.&lt;/b&gt; Klicke rechts in der Werkzeugleiste auf das Material, dann auf seine Dicke, und gib ein, was du gemessen hast: Alle Schlitze folgen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;Klappt es?&lt;/b&gt; Das sagen die Plaketten über der Ansicht. Klicke auf eine, um mehr zu lesen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Wiederhole sie.&lt;/b&gt; Wähle &lt;b&gt;Reihe&lt;/b&gt;, klicke auf die Scheibe quer zum Körper, dann auf den Körper: Kopien stehen in einer Reihe an ihm entlang.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Das war der ganze Weg,&lt;/b&gt; vom ersten Strich bis zur Datei. Was rot ist, lässt sich unter Prüfungen mit einem Klick beheben. Mehr steht unter &lt;b&gt;F1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Fast.&lt;/b&gt; Ziehe den runden Griff am Ende der Reihe zurück, bis keine Plakette mehr rot ist; dann schreibt &lt;b&gt;Export …&lt;/b&gt; die Datei für den Cutter.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;Das ist sehr klein.&lt;/b&gt; Mach es rückgängig und zeichne es größer, etwa halb so breit wie die Ansicht.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Hier endet der Rundgang.&lt;/b&gt; Im Menü &lt;b&gt;Hilfe&lt;/b&gt; kannst du ihn noch einmal machen. Mehr steht unter &lt;b&gt;F1&lt;/b&gt;.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Das wurde in einem anderen Fenster geöffnet oder verworfen.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Eine Kopie ungespeicherter Arbeit stammt von einem neueren FlatFitFab; sie bleibt unter %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Eine Kopie ungespeicherter Arbeit ließ sich nicht lesen; sie bleibt unter %1.</translation>
    </message>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>Ungespeichertes kann nicht für den Fall eines Absturzes gesichert werden. Besser speichern.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>Das Gesicherte konnte nicht geöffnet werden: %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Ganze Zahl</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja oder nein</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>small</source>
        <translation>klein</translation>
    </message>
    <message>
        <source>large</source>
        <translation>groß</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>klein | groß</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Ergibt sich aus</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>wofür er da ist</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Das lässt sich nicht als das lesen, was hier gebraucht wird.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>Was aus ihm entsteht, wird zu einfachen Zahlen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>Überschrift darüber</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Er lässt sich einstellen, wo der Entwurf zum Anpassen weitergegeben wird</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Andere können ihn anpassen</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueEditor</name>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRow</name>
    <message>
        <source>Name of the value</source>
        <translation>Name des Werts</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Art, Bereich und Notiz</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Nur für dich</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is what is wrong, such as &quot;Falls over&quot;, %2 in how many places it is</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>Von %1 Ecken wurden %2 probiert.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a value, %2 what it is: &quot;width 400 mm&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;width 400 mm, boards 6&quot;, %2 what is wrong there</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n other(s)</source>
        <translation>
            <numerusform>und %n andere</numerusform>
            <numerusform>und %n andere</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Die Bereiche werden probiert … %1 %</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal probieren</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Alle Bereiche probieren</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Bereiche einengen</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Sagt, wo in den Bereichen der gezeigten Werte das Modell nicht zusammenzubauen ist, bricht, umfällt oder nicht passt.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>Die eine probierte Variante ist gut.</numerusform>
            <numerusform>Alle %n probierten Varianten sind gut.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n variant(s) fail: %2.</source>
        <extracomment>%1 is a number, %2 a list such as &quot;Falls over (5), Breaks (2)&quot;</extracomment>
        <translation>
            <numerusform>%1 von %n Variante taugt nicht: %2.</numerusform>
            <numerusform>%1 von %n Varianten taugen nicht: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>Enger ist jetzt der Bereich von: %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Neuer Wert</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>wert</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Dieser Entwurf ist zum Anpassen da: Stelle seine Werte ein und exportiere ihn dann. Ziehen in der Ansicht dreht ihn.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>An diesem Entwurf gibt es nichts anzupassen.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Entwurf bearbeiten</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Zum Anpassen weitergeben</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Holt Zeichnen und alle Fenster zurück; wird jetzt gespeichert, geht die Datei so auf.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Wer das gespeicherte Modell öffnet, sieht die Ansicht, die gezeigten Werte und den Export, sonst nichts.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>Er wird aus %1 geschnitten.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Gib einer Zahl einen Namen: Jedes Feld kann ihn benutzen, auch in Rechnungen wie = 2*luft.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Wie das Modell gezeigt wird</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Klicken zeigt die Scheiben wieder, wie sie sind.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufgeschnitten</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Klicken zeigt wieder das ganze Modell.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>OBEN</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>UNTEN</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>VORN</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>HINTEN</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>RECHTS</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>LINKS</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>Ansicht des Modells</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Mit der linken Maustaste zeichnen, mit der rechten drehen.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 für die Werkstatt</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Die Schritte sind nicht bei den Dateien: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Wohin der Ordner „%1“ soll</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Hierhin</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>auf diesem Bildschirm lässt sich kein Bild machen.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Zeichnet flache Teile in 3D und schneidet sie.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Öffnet FILE als Kopie: Speichern fragt nach einem Namen.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Spielt ein Skript von Drücken und Bewegen ab.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>SKRIPT</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Startet ohne das, was eingestellt wurde, und behält keine Einstellungen.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modelle zum Öffnen, jedes in einem Fenster; Zeichnungen, Netze und Bilder für ein neues.</translation>
    </message>
</context>
</TS>
