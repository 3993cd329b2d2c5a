<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n onderdeel als één geheel</numerusform>
            <numerusform>%n onderdelen als één geheel</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (onderdeel %2)</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (samen sinds stap %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n andere</numerusform>
            <numerusform>%n andere</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>omhoog</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>omlaag</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>naar rechts</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>naar links</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>naar voren</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>naar achteren</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>in de richting van de pijl</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Er is nog geen sectie, dus er zijn geen stappen.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>Van dit model wordt niets gesneden, dus er zijn geen stappen.</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Geen stappen te tonen: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>Geen stappen te tonen: de montagevolgorde is niet op tijd gevonden.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>Geen stappen te tonen: het model kan niet in elkaar, omdat %n sectie vastzit.</numerusform>
            <numerusform>Geen stappen te tonen: het model kan niet in elkaar, omdat %n secties elkaar blokkeren.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>Geen stappen te tonen: het model kan niet in elkaar, omdat onderdelen van %1 elkaar blokkeren.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>Geen stappen te tonen: het model kan niet in elkaar, omdat %1 elkaar blokkeren.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Stap %1 van %2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>begin met %1</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>begin een aparte groep met %1</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>leg %1 op zijn plaats</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>breng %1 om de hoek naar binnen, als laatste %2</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>breng %1 om de hoek naar binnen en schuif dan %2 in %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>schuif %1 %2 op zijn plaats</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>schuif %1 %2 in %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Draagt hier nog %1, dan scheurt %2 %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Draagt hier %1, dan scheurt %2 %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Draagt hier nog %1, dan valt het om.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Draagt hier %1, dan valt het om.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Draagt hier nog %1, dan wordt een verbinding uit elkaar getrokken.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Draagt hier %1, dan wordt een verbinding uit elkaar getrokken.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Draagt hier meer dan %1.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>Hoeveel het hier draagt, was niet te berekenen.</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Grondvlak verbreden</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Voet toevoegen</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Verbonden. Nog maar één sectie.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 verbinding</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n verbinding</numerusform>
            <numerusform>%n verbindingen</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Verbonden. Beide secties, met %1.</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Verbonden. Alle %1 secties, met %2.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Zou verbonden zijn %1.</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 is niet met de rest verbonden.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 zijn niet met de rest verbonden.</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 raakt %2, maar niets houdt ze bij elkaar.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 raken %2, maar niets houdt ze bij elkaar.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Niets raakt %1. De afstand tot %3 is %2.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Verder raakt niets %1. De afstand tot %3 is %2.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Alle verwijderen</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbonden</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Zou verbonden zijn</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Niet verbonden</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Teken een sectie dwars door beide, of verplaats de ene naar de andere.</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Nog niet verbonden</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>als het bij elkaar bleef</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>als er niets uit elkaar viel</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>als de snijbreedte geen sleuf dichtmaakte</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>als er geen sleuf te krap was</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>als er geen sleuf te ruim was</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>als het niet inklapte</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>als het niet weggleed</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>als er niets losliet</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>als er geen verbinding uit elkaar werd getrokken</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>als er niets tegen duwde</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>De ene bij de andere laten eindigen</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 bij %2 laten eindigen</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>Hun verbinding staat op “Geen”.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Met geen enkele sleuf schuiven ze in elkaar: door de negatieve speling blijft er geen breedte over. Maak de speling groter.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Met geen enkele sleuf schuiven ze in elkaar: op de ene plek kan het maar de ene kant op, op de andere alleen de andere kant op. Kort een van de twee in.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Niets zou ze vasthouden: waar sleuven zouden beginnen, zitten gaten. Maak de gaten kleiner, of laat een van de twee binnen de andere eindigen.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Met geen enkele sleuf schuiven ze in elkaar: geen van beide komt tot aan de rand. Maak een gat open naar buiten, of laat een van de twee er helemaal doorheen lopen.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 en %2 overlappen elkaar over een lengte van %3. %4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>minder dan %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 en %2 overlappen elkaar %3, buiten hun sleuven.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 en %2 overlappen elkaar %3, maar zijn niet verbonden.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 en %2 liggen bijna in één vlak: ze komen samen onder %3, en onder de %4 houdt geen sleuf ze vast.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 en %2 komen samen onder %3; onder de %4 worden sleuven breed.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Schuif een van de twee opzij, of laat die vóór de andere eindigen.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Secties overlappen elkaar</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Hoek te vlak</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Draai een van de twee haakser op de andere.</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Met elkaar verbinden</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Met %1 verbinden</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Alle met %1 verbinden</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Naar %1 verplaatsen</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Alle naar %1 verplaatsen</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 inkorten</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Met lippen verbinden</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 houdt %2 niet vast: de sleuf loopt langs de rand en heeft maar aan één kant materiaal.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 houdt %2 niet vast: de sleuven snijden daar helemaal door.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 houdt %2 niet vast: de sleuf is minder dan %3 diep.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 houdt %2 niet vast: de sleuf laat aan geen van beide kanten materiaal over.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 houdt %2 niet vast: andere sleuven nemen weg wat in deze sleuf zou zitten.</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Schuif de sleuf van de rand af.</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Laat een van de secties die elkaar daar kruisen vóór de andere eindigen, of schuif die opzij.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>Sleuf houdt niets vast</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>Sleuven snijden %1 in %2 stukken</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 komt in %2 stukken van de machine</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; een daarvan, %2 groot, wordt door niets vastgehouden.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; niets houdt ze vast, het grootste is %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1; %2 daarvan worden door niets vastgehouden, het grootste is %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>Sleuven snijden %1 in stukken. Wat is afgesneden, hangt samen maar wordt door niets vastgehouden.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>Sleuven snijden %1 in stukken. Wat is afgesneden, wordt samen met %2 door niets vastgehouden.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>Sleuven snijden %1 in stukken. Niets houdt het stuk van %2 met %3 vast.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Sleuven omdraaien</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Losse onderdelen</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 van de rand af schuiven</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 wegschuiven</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Sleuf minder diep maken</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>Sleuf %1 valt dicht door de snijbreedte van %2. Geef de sleuven van het materiaal meer speling, of neem een kleinere snijbreedte.</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>Sleuf %1 is smaller dan het gereedschap van %2. Geef de sleuven van het materiaal meer speling of kies dunner gereedschap.</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Tussen de noppen zijn sleuven %1 smaller dan wat erin komt. Dat is voor elk materiaal te krap: maak de noppen kleiner.</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>Sleuven zijn %1 smaller dan wat erin komt. Dat is voor elk materiaal te krap.</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>Sleuven zijn %1 breder dan wat erin komt, dus het zit los.</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Speling instellen</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Sleuven te krap</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Sleuven te ruim</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Sleuf smaller dan het gereedschap</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Opnieuw proberen</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Kopie voor een foutmelding tonen</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Niet berekend</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Kan in elkaar. Nog maar één onderdeel.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Kan in elkaar. Maar niets houdt een van de onderdelen vast.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Kan in elkaar. Maar niets houdt %n van de onderdelen vast.</numerusform>
            <numerusform>Kan in elkaar. Maar niets houdt %n van de onderdelen vast.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Kan in elkaar. %n stap.</numerusform>
            <numerusform>Kan in elkaar. %n stappen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Zou in elkaar kunnen %1.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Kan nog niet in elkaar. Het zou kunnen als twee secties elkaar niet overlapten.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Kan nog niet in elkaar. Het zou kunnen als %n paar secties elkaar niet overlapte.</numerusform>
            <numerusform>Kan nog niet in elkaar. Het zou kunnen als %n paar secties elkaar niet overlapten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Stappen tonen</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>Secties blokkeren elkaar. %1 komen samen in %2 die in %3 verschillende richtingen schuiven.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>Secties blokkeren elkaar. %1 komt maar %2 uit de sleuf en stuit dan op %3.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>Secties blokkeren elkaar. Van %1 kan er geen enkele recht uit.</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Montage mogelijk maken</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>1 verbinding omgedraaid.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>%n verbinding omgedraaid.</numerusform>
            <numerusform>%n verbindingen omgedraaid.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Volgorde niet gevonden: %1.</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Volgorde niet gevonden. Het zoeken duurde te lang; dat zegt niets over het model.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Kan in elkaar</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Zou in elkaar kunnen</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Kan nog niet in elkaar</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>Kan niet in elkaar</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Kort een ervan in, of draai die zo dat ze in dezelfde richting schuift als de andere.</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Volgorde niet gevonden</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Uit elkaar getrokken. Aan de verbinding van %1 en %2 trekt %3 N.</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>Draagt niets. De verbinding van %1 en %2 wordt met %3 N uit elkaar getrokken; de andere houden het zonder deze.</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Zit alleen op wrijving. Aan de verbinding van %1 en %2 trekt %3 N, en dat houdt alleen een krappe passing.</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Uit elkaar getrokken</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>Draagt niets</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>De sleuven omdraaien</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Lijm de verbinding.</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Zit alleen op wrijving</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Omgeduwd. Als er niet tegen werd geduwd, zou het staan.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Omgeduwd</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Geef het een breder grondvlak of meer gewicht, of duw minder hard of lager.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 zijn in een kring verbonden: zet ze in elkaar in de volgorde van de stappen.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 zijn in een kring verbonden: welke je ook als laatste plaatst, die moet op twee andere tegelijk schuiven.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Secties zijn in %n kring verbonden: zet ze in elkaar in de volgorde van de stappen.</numerusform>
            <numerusform>Secties zijn in %n kringen verbonden: zet ze in elkaar in de volgorde van de stappen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Secties zijn in %n kring verbonden: welke je ook als laatste plaatst, die moet op twee andere tegelijk schuiven.</numerusform>
            <numerusform>Secties zijn in %n kringen verbonden: welke van een kring je ook als laatste plaatst, die moet op twee andere tegelijk schuiven.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>In een kring verbonden</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Met een voet ondersteunen</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 plaat</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n plaat</numerusform>
            <numerusform>%n platen</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Past op de plaat. %1, %2&#x202f;% gebruikt.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Past op de plaat. %1 van %2, %3&#x202f;% gebruikt.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%1 onderdelen van %2 passen op geen enkele plaat van %3 met een rand van %4, hoe je ze ook draait.</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 is %2 groot en past op geen enkele plaat van %3 met een rand van %4, hoe je het ook draait.</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Een plaat kiezen</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Past op de plaat</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>Te groot voor de plaat</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Tot de grond verlengen</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 tot de grond verlengen</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Op de grond zetten</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Tot op de grond optillen</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Staat, maar wiebelt %1. Kantelt pas voorbij %2. Marge %3.</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Staat. Kantelt pas voorbij %1. Marge %2.</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Staat %1 scheef. Kantelt pas voorbij %2. Marge %3.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>Het laagste punt van %1 zit %2 boven de grond.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>De laagste punten van %1 zitten tot %2 boven de grond.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Helt %1 voorover</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Helt %1 achterover</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Helt %1 naar zijn linkerkant</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Helt %1 naar zijn rechterkant</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Wiebelt %1: de laagste punten zijn niet allemaal op de grond. Kantelt pas voorbij %2.</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1 voordat het staat: de laagste punten zijn niet allemaal op de grond. Kantelt pas voorbij %2.</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Zou staan %1. Zou pas voorbij %2 kantelen. Marge %3.</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Valt bij de minste tik: bij %1 kantelen valt het al om. Marge %2.</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Staat maar net: bij %1 kantelen valt het al om. Marge %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Wiebelt</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Staat scheef</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Valt bij de minste tik</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Kantelt snel</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Valt voorover. Het zwaartepunt ligt %1 vóór de voeten.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Valt achterover. Het zwaartepunt ligt %1 achter de voeten.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Valt op zijn linkerkant. Het zwaartepunt ligt %1 buiten de voeten.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Valt op zijn rechterkant. Het zwaartepunt ligt %1 buiten de voeten.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Valt om. Alle voeten staan op één lijn, dus niets houdt het overeind.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>Niet op de grond. Het laagste punt ervan zit er %1 boven.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>Niet op de grond. Het laagste punt zit er %1 boven.</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Geef het nog een voet, of verplaats gewicht tot boven de voeten.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Verbind het met wat staat, of verplaats het naar de grond.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Staat nog niet</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Nog niet op de grond</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Staat</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Zou staan</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Laat alle voeten op dezelfde hoogte eindigen.</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Valt om</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>Niet op de grond</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 keer zo veel</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>de belasting</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Sterk genoeg</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Draagt %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Zou sterk genoeg zijn</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Zou %1 dragen</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Kan scheuren</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Maar net sterk genoeg</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Kan scheuren bij %1</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Draagt maar net %1</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Breekt</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Te zwak</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Breekt bij %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Te zwak voor %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 breekt vanaf %3 %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 kan vanaf %3 scheuren %2;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>de smalste plek breekt bij %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>de smalste plek van %1 breekt bij %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 kan vanaf %3 scheuren %2.</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Bij %1 wordt een verbinding uit elkaar getrokken.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Bij %1 staat het niet meer.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Het zou veel meer dragen.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>Hoeveel het zou dragen, was niet te berekenen.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>Niets belast het.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Het zwakst is %1, %2: belast tot minder dan 1&#x202f;% van de sterkte.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>Het zwakst is %1, %2: belast tot %3&#x202f;% van de sterkte.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Buigt %1 door.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>De smalste plek van %1 is belast tot %2&#x202f;% van de sterkte.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>Dat is minder dan de veiligheidsfactor van %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Sterkte onbekend. Voor het materiaal van %1 is geen sterkte ingevuld.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Sterkte onbekend. De krachten tussen de secties waren niet te berekenen.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Sterkte onbekend. De spanning in %1 was niet te berekenen.</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Glijdt weg. De voeten houden het niet tegen: duw minder hard, of geef het meer gewicht.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Laat los. Niets houdt %1 op zijn plaats: lijm de verbindingen, of voeg er een toe.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Klapt in. Vingers draaien als scharnieren en verder houdt niets %1 tegen: lijm ze, of verbind ze met nog een sectie.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Naast het materiaal. Een gewicht op %1 ligt niet op materiaal; de dichtstbijzijnde plek vangt het op.</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Neem dikker materiaal, maak het daar breder, of zet er minder op.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Sterkte onbekend</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Laat los</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Klapt in</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Naast het materiaal</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Materiaal van %1 dik nemen</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Dikker materiaal nemen</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Sterkte invullen</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Valt uit elkaar. %1 hangt aan minder dan er te snijden is.</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Te weinig materiaal. %1 is op één plek maar %2 breed.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Valt uit elkaar</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Maak het daar breder, of schuif uit elkaar wat elkaar raakt.</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Te weinig materiaal</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Maak het daar breder.</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: de sleuven voor %2 lopen in elkaar over.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: tussen de sleuven voor %2 blijft niets over.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: tussen de sleuf voor %2 en een gat blijft niets over.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: tussen de sleuf voor %2 en de rand blijft niets over.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: tussen de sleuven voor %3 blijft maar %2 materiaal over.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: tussen de sleuf voor %3 en een gat blijft maar %2 materiaal over.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: tussen de sleuf voor %3 en de rand blijft maar %2 materiaal over.</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Vrij dun</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Maak de sectie daar breder, of verplaats de sleuf.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Sleuven lopen in elkaar over</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Massa %1. Het zwaartepunt ligt %2 boven de grond.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 en %2 raken elkaar alleen: ze overlappen elkaar minder dan %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n paar secties raakt elkaar alleen: ze overlappen elkaar minder dan %1.</numerusform>
            <numerusform>%n paar secties raken elkaar alleen: ze overlappen elkaar minder dan %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Raken elkaar alleen</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 op 90° draaien</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sleuven snijden een splinter kleiner dan 1 mm² van %1 af. Die is afval en krijgt geen nummer.</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Sleuven snijden %n splinter kleiner dan 1 mm² van %1 af. Die is afval en krijgt geen nummer.</numerusform>
            <numerusform>Sleuven snijden %n splinters kleiner dan 1 mm² van %1 af. Die zijn afval en krijgen geen nummer.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Afval</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>De sleuven verdelen %1 in %2, bij elkaar gehouden door andere secties.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n onderdeel</numerusform>
            <numerusform>%n onderdelen</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>De sleuven laten niets van %1 over.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>%1 kon niet worden uitgesneden: wat de sleuven ervan overlaten, was niet te berekenen. Er kan niets worden geëxporteerd; de massa telt zonder sleuven.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 kon niet worden berekend: er ontbreken secties. Er kan niets worden geëxporteerd.</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Door sleuven verdeeld</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>Niets over</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Niet uitgesneden</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>Operatie mislukt</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Daar breder maken</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n sectie verplaatst</numerusform>
            <numerusform>%n secties verplaatst</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n sectie over %1 omlaag verplaatst</numerusform>
            <numerusform>%n secties over %1 omlaag verplaatst</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>%n sectie over %1 omhoog verplaatst</numerusform>
            <numerusform>%n secties over %1 omhoog verplaatst</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>1 verbinding omgedraaid</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>%n verbinding omgedraaid</numerusform>
            <numerusform>%n verbindingen omgedraaid</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 wordt %2 dik</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>De sleuven van 1 verbinding komen ergens anders samen</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>De sleuven van %n verbinding komen ergens anders samen</numerusform>
            <numerusform>De sleuven van %n verbindingen komen ergens anders samen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 over %2 verplaatst</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1 over %2 gedraaid</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>%n sectie gedraaid</numerusform>
            <numerusform>%n secties gedraaid</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>een nieuwe verbinding met een sleuf van %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 nieuwe verbinding</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n nieuwe verbinding</numerusform>
            <numerusform>%n nieuwe verbindingen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>vorm van %1 gewijzigd</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>vorm van %n sectie gewijzigd</numerusform>
            <numerusform>vorm van %n secties gewijzigd</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 toegevoegd</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n sectie toegevoegd</numerusform>
            <numerusform>%n secties toegevoegd</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 verwijderd</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n sectie verwijderd</numerusform>
            <numerusform>%n secties verwijderd</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>verder wordt er niets doorgesneden</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>1 probleem opgelost</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n probleem opgelost</numerusform>
            <numerusform>%n problemen opgelost</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>dan: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>nieuw: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n nieuwe opmerking</numerusform>
            <numerusform>%n nieuwe opmerkingen</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>naast de sleuf voor %1</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>bij de aansluiting op %1</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>in een binnenhoek</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>op de smalste plek</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>In kringen verbonden</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>In de grond. %1 steekt er %2 onder.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>In de grond. %1 steken er tot %2 onder.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>In de grond</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Vlakken %1 % verschuiven</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>Eén vlak meer per richting</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Past op de platen en reststukken die er zijn.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>Hoogstens %n plaat</numerusform>
            <numerusform>Hoogstens %n platen</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Past op de plaat. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Past op de plaat. %1 van %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Secties overlappen elkaar iets</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>De platen kunnen opraken. Er is tot %n plaat van %1 nodig, en er zijn er %2.</numerusform>
            <numerusform>De platen kunnen opraken. Er zijn tot %n platen van %1 nodig, en er zijn er %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>De platen kunnen opraken</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Kijk bij Platen hoe dicht de onderdelen bij elkaar kunnen liggen.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Een vlak om de %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, %2 % verschoven</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>Eén vlak meer</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>Eén vlak minder per richting</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>Eén vlak minder</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>Twee vlakken meer per richting</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>Twee vlakken meer</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>Twee vlakken minder per richting</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>Twee vlakken minder</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Geen van de geprobeerde verschuivingen en aantallen vlakken laat ze in elkaar schuiven. Zet de schijven om en kort een ervan in, of laat die weg.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>Dit model is er om aan te passen; met “Ontwerp bewerken” komt alles terug</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Openen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Een model openen, ook uit FlatFab</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>Model invoegen…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Invoegen</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>De secties van een ander model aan dit model toevoegen</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>Sjabloon om over te tekenen…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Sjabloon</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Een mesh, afbeelding of tekening inlezen om er secties over te tekenen</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>Aan de bibliotheek toevoegen</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>Bibliotheek</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>De selectie in de bibliotheek bewaren, voor andere modellen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Het model opslaan</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Opslaan als…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Opslaan als</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Het model onder een andere naam opslaan</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Snijbestanden exporteren…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>De onderdelen naar een bestand voor de lasersnijder schrijven</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Nog eens exporteren</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Nog eens exporteren</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Hetzelfde bestand opnieuw schrijven, met dezelfde keuzes</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Terug naar opgeslagen versie</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Terug naar het model zoals het in het bestand staat; met Ongedaan maken komen de wijzigingen terug</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Instellingen…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Instellingen</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Eenheden, kleuren, taal, bestanden en sneltoetsen</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Sneltoetsen…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Sneltoetsen</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Bekijken welke toetsen wat doen, en je eigen toetsen kiezen</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Venster sluiten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Dit venster sluiten; andere blijven open</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Afsluiten</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Afsluiten</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Alle vensters en het programma sluiten</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Naar Eigenschappen</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschappen</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Naar het eerste veld van de selectie; in het beeld doet Enter hetzelfde</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Alle panelen verbergen</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Panelen weg</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>De panelen aan de zijkanten verbergen of tonen</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Volledig scherm</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Volledig scherm</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Het hele scherm met het venster vullen</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Venster herstellen</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Venster herstellen</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Alle panelen weer op hun oorspronkelijke plaats zetten</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Volgend deel van het venster</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Volgend deel</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Naar het volgende deel van het venster: werkbalk, links, beeld, rechts</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Vorig deel van het venster</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Vorig deel</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Terug naar het vorige deel van het venster</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>Volgend probleem</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Volgend probleem</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>De secties van het volgende probleem selecteren en tonen</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>Vorig probleem</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Vorig probleem</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>De secties van het vorige probleem selecteren</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Stappen tonen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stappen</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Stap voor stap tonen hoe het model in elkaar gaat</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Materialen…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Materialen</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Plaatmateriaal: dikte, sterkte, snijbreedte en plaatmaat</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Pasproef…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Pasproef</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Een proefstukje schrijven dat laat zien welke sleuven passen en hoe breed de machine snijdt</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>Platen</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Platen</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>De onderdelen op hun platen tonen, zoals ze worden gesneden</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Naar de waarden</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Waarden</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>De waarden aanpassen waaruit getallen van het model volgen</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nieuwe waarde</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Een getal met een naam, die je in getalvelden kunt invullen</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Opdracht zoeken…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Typ om alles te vinden wat het programma kan</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>Eerste stappen</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Eerste stappen</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Hoe je een model maakt, stap voor stap, met plaatjes</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Startpagina</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startpagina</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Recente modellen en voorbeelden</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>Over FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Over</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>Wat dit programma is, de versie en de licenties</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Het is nog niet geëxporteerd</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Het is nog nooit opgeslagen</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Er is niets gewijzigd sinds het opslaan</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Sterktekaart</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Sterktekaart</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Een sectie kleuren naar de massa die elke plek ervan kan dragen</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Selecteer eerst de sectie die je wilt bekijken</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Selecteer eerst één sectie</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>Geen verbinding geselecteerd: selecteer een sectie en dan een van de verbindingen</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>Er is geen andere sectie</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>Geen operatie geselecteerd</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Er is nog geen sectie</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>Geen sectie geselecteerd</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Knippen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Knippen</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>De geselecteerde secties kopiëren en verwijderen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Kopiëren</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiëren</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>De geselecteerde secties kopiëren, ook voor andere vensters en programma’s</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Plakken</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Plakken</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>De gekopieerde secties toevoegen, of een afbeelding om over te tekenen</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>Een kopie van de geselecteerde secties ernaast zetten</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>In X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>Spiegelen X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Een spiegelbeeld van de geselecteerde secties aan de andere kant zetten van het vlak waar X 0 is</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>In Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Spiegelen Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Een spiegelbeeld van de geselecteerde secties aan de andere kant zetten van het vlak waar Y 0 is</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>In Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Spiegelen Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Een spiegelbeeld van de geselecteerde secties aan de andere kant zetten van het vlak waar Z 0 is</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>In een sectie…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Klik op een sectie: een spiegelbeeld van de geselecteerde secties komt aan de andere kant ervan</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Secties uit SVG…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>Uit SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Een sectie voor elke omtrek van een tekening</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>Contour uit SVG…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Contour uit SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>De grootste omtrek van een tekening in plaats van die van de geselecteerde sectie</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>Gaten uit SVG…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Gaten uit SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Een gat in de geselecteerde sectie voor elke omtrek van een tekening</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>Markeringen uit SVG…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Markeringen uit SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>De lijnen van een tekening, gegraveerd of geritst op de geselecteerde sectie</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Vorm tekenen</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Een cirkel, rechthoek of iets dergelijks vanuit het midden slepen</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>Cirkel</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cirkel</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>Met getallen: een gat in de geselecteerde sectie, of een eigen sectie</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>Ellips</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellips</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Veelhoek</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Veelhoek</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>Ster</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Ster</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>Slobgat</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Slobgat</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Sjabloon verplaatsen</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Grepen</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Het sjabloon met grepen of getallen verplaatsen, draaien en schalen</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Sjabloon schalen met een lijn</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Maat met lijn</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Een lijn over het sjabloon trekken en zeggen hoe lang die is</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>Er is geen afbeelding en geen tekening: voeg er eerst een toe</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>Er is geen sjabloon: voeg eerst een mesh of een afbeelding toe</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Sleuven van de verbinding omdraaien</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Sleuven omdraaien</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>De sleuven van de geselecteerde verbinding naar de andere kant laten openen</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Automatische instellingen herstellen</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Het programma weer de soort, de richting en de trefpunten van de geselecteerde verbinding laten kiezen</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>Aan deze verbinding is niets met de hand ingesteld</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>Gewicht toevoegen</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Een gewicht op een sectie zetten om te zien wat die kan dragen</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>Duw toevoegen</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Duw</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>Op één plek tegen een sectie duwen of eraan trekken om te zien wat die kan dragen</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>Hier trekken</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Trekken</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Met de muis aan een sectie trekken om te zien wat er gebeurt; er wordt niets bewaard</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Niets belast het model: voeg eerst een gewicht of een duw toe</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>Er is geen mesh om naar zich toe te trekken</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Tekst of lijnen graveren</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Graveren</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Op een sectie schrijven of tekenen, om te graveren of te ritsen</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>Graveren</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>Wat je hierna tekent, wordt gegraveerd</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>Ritsen</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Ritsen</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>Wat je hierna tekent, wordt geritst, om langs te vouwen of te breken</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Meten</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Meten</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>Tussen twee plekken meten; de lengte behouden, of het model ernaar schalen</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Schalen naar lengte</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Schalen naar lengte</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Een lengte opgeven en het model ernaar schalen</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Lengte behouden</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behouden</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Deze lengte blijven tonen</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Deze maat verwijderen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Deze maat verwijderen</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>Er is niets gemeten</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>Geen maat gekozen: klik er met Meten een aan</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>Spiegelen…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>De geselecteerde secties spiegelen, of de ene kant van het model naar de andere</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Links en rechts spiegelen (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>Spiegelen in het vlak waar X 0 is</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Boven en onder spiegelen (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Spiegelen in het vlak waar Y 0 is</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Voor en achter spiegelen (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Spiegelen in het vlak waar Z 0 is</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>Spiegelen in een sectie</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sectie</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>Spiegelen in het vlak van de sectie waarop je klikt</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Gespiegelde kopie van de selectie</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Een spiegelbeeld van de geselecteerde secties toevoegen</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Beide kanten gelijk houden</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide kanten</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Alles spiegelen wat aan één kant is getekend, nu en later</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Eén keer symmetrisch maken</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Eén keer</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>De ene kant naar de andere kopiëren; latere wijzigingen gaan niet mee</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Spiegelen zoals getoond</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Uitvoeren wat je ziet</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Kies eerst Spiegelen</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>Voorgestelde vorm overnemen</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Overnemen</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Van wat je net tekende de voorgestelde cirkel, ellips, rechte lijnen of rechte hoeken maken, of de sleuf van de rand af schuiven</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>Hele hulplijn overnemen</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Hulplijn</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>De sectie maken van alles wat het vlak uit een sjabloon snijdt, met de gaten erin</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>Voor wat je net tekende, is er geen voorstel</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>Het vlak waarop je tekent, snijdt geen sjabloon</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>Rij</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Rij</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>Een sectie in een rij langs een andere herhalen</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>Rondom langs contour</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Rondom</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Een sectie rondom de contour van een andere herhalen</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Overgang</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Overgang</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Tussenvormen maken tussen secties</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>Vertakking</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Takken</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Kopieën van een sectie uit zichzelf laten groeien, als een boom</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Raster met koppelstukken</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Een sectie verdelen die te groot is voor de plaat</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>Radiale contour</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radiaal</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>Van een sectie een cirkel, ster of tandwiel maken, of zulke gaten erin snijden</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>Model spiegelen</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Alles wat aan de ene kant is getekend, aan de andere kant herhalen</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Draaisymmetrie</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Alles wat één keer is getekend, rond een as herhalen</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>Reeks</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Reeks</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>Secties langs een lijn door de ruimte herhalen</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>Schijven uit een mesh</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schijven</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Een mesh waarover je tekent in secties snijden die de vorm volgen</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>Nu symmetrisch maken</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>De ene kant naar de andere spiegelen, één keer</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>Uit- of inschakelen</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Aan</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>De geselecteerde operatie uitschakelen, of weer inschakelen</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>Eerder in de volgorde</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Eerder</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>De geselecteerde operatie vóór die erboven uitvoeren</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>Later in de volgorde</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Later</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>De geselecteerde operatie na die eronder uitvoeren</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>Omzetten in secties</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Omzetten</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Wat de geselecteerde operatie maakt, omzetten in getekende secties</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>Er is geen mesh om in schijven te snijden: voeg er eerst een toe</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>Dit is de eerste al</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>Dit is de laatste al</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Vastklikken</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Vastklikken</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>Vastklikken op punten, uitlijnlijnen en raster</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Pen</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Pen</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Met klikken tekenen in plaats van in één haal: punten zetten, slepen om te buigen</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>Er is geen getal getypt</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Gaten verwijderen</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Geen gaten</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Alle gaten van de geselecteerde secties dichtmaken</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Punt toevoegen</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punt toevoegen</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Een controlepunt toevoegen onder de aanwijzer, of naast het geselecteerde punt</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Punt verwijderen</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Punt verwijderen</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>De geselecteerde controlepunten verwijderen</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Vloeiend punt</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Vloeiend</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>De contour vloeiend maken bij de geselecteerde punten</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>Symmetrisch punt</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>De contour vloeiend maken, met even lange grepen aan beide kanten</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Hoekpunt</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Van de geselecteerde punten hoeken maken</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>Geen punt van een contour geselecteerd</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Selecteer één sectie waarvan de contour te bewerken is</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>De selectie heeft geen gaten</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Verplaatsen en draaien</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verplaatsen</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Met grepen of getallen verplaatsen, draaien en schalen</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>Langs de wereldassen</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Wereldassen</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Verplaatsen langs de assen van de wereld, niet in het vlak van de sectie</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Aanhangende secties meenemen</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Meenemen</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Secties die op deze zijn getekend, gaan mee</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Op een andere sectie zetten…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Zetten op</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Klik op de sectie waarop je de geselecteerde wilt zetten</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Vrijmaken van de sectie waarop ze zit</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Vrij</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Vrijmaken van de sectie waarop ze zit: ze beweegt niet meer mee en houdt haar hoek niet meer</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Haaks zetten</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Haaks</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>De sectie haaks zetten op de sectie waarop ze zit</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>Uitlijnen op dichtstbijzijnde as</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Uitlijnen</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>De sectie zo draaien dat ze langs een wereldas kijkt</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>Vergrendelen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Vergrendelen</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>De geselecteerde secties tegen wijzigingen beschermen</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>Bron bewerken</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Bron bewerken</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>De sectie selecteren waarvan de geselecteerde is gemaakt</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>Deze losmaken</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Losmaken</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>Van de geselecteerde sectie een getekende maken; de operatie maakt de andere nog wel</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>Deze weglaten</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Weglaten</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>De geselecteerde sectie weglaten; de operatie maakt de andere nog wel</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>De selectie zit niet op een andere sectie</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>De selectie is door een operatie gemaakt</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>De selectie is niet symmetrisch</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>De selectie is getekend, niet door een operatie gemaakt</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Alles selecteren</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles selecteren</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Alle secties selecteren</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Volgende selecteren</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Volgende</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>De volgende sectie selecteren</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Vorige selecteren</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>De vorige sectie selecteren</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>Verbonden secties selecteren</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbonden</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Alle secties selecteren die met de geselecteerde verbonden zijn</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>Parallelle secties selecteren</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Alle secties selecteren die parallel zijn aan de geselecteerde</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Zelfde materiaal selecteren</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Zelfde materiaal</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Alle secties selecteren van hetzelfde materiaal als de geselecteerde</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Nieuw</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nieuw</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Een nieuw model beginnen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>De laatste stap ongedaan maken</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>De ongedaan gemaakte stap opnieuw uitvoeren</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>De geselecteerde secties verwijderen</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Punt zetten</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Niets om ongedaan te maken</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>“%1” ongedaan maken</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Niets om opnieuw uit te voeren</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>“%1” opnieuw uitvoeren</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Alle onderdelen lospinnen</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Alles lospinnen</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Alle onderdelen weer laten verschuiven als ze op platen worden gelegd</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>Er is geen onderdeel op zijn plaat vastgepind</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>Huid</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Huid</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>De vorm tonen die de secties suggereren, als een oppervlak eroverheen</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Lokale symmetrie</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Een contour in de sleuf spiegelen als die maar aan één kant ervan is getekend</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Bij de grond recht afsnijden</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Grond</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Afsnijden wat onder de grond is getekend</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>Op de grond</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Op de grond</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Een sectie tekenen die op de grond ligt</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>Op het voorvlak</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>Voorvlak</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Een sectie rechtop in het midden tekenen, van voren gezien</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>Op het zijvlak</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Zijvlak</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Een sectie rechtop in het midden tekenen, van opzij gezien</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>Parallel aan de sectie</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Een sectie tekenen die parallel is aan de geselecteerde</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Contour opnieuw tekenen</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Een nieuwe contour voor de geselecteerde sectie tekenen</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>Gat tekenen</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Gat</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>Een gat in de geselecteerde sectie tekenen</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Op de grond zetten</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Neerzetten</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Het model op de grond zetten</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>Het model staat al op de grond</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Doorgeven om aan te passen</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Doorgeven</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Wie het opgeslagen model opent, ziet het beeld, de getoonde waarden en Exporteren, en verder niets</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Ontwerp bewerken</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Anderen kunnen nog geen waarde aanpassen</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Voor</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Voor</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Van voren bekijken</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Boven</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Boven</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Van boven bekijken</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Van rechts bekijken</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Achter</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Achter</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Van achteren bekijken</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Onder</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Onder</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Van onderen bekijken</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Van links bekijken</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Volgende hoek</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Vanuit de volgende hoek bekijken</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Recht op de sectie kijken</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Recht erop</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Recht op de geselecteerde sectie kijken</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Alles in beeld</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>In beeld</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Het hele model in beeld brengen</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Selectie in beeld</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Selectie in beeld</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>De geselecteerde secties zo groot mogelijk in beeld brengen</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Vorig beeld</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Terug naar het vorige beeld</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspectief</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspectief</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>Wat verder weg is kleiner tonen, zoals het oog het ziet</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Door alle secties heen kijken, tot op de sleuven</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Alleen de selectie</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoleren</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Alle andere secties vaag tonen</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>De geselecteerde secties verbergen</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>De verborgen secties weer tonen</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Model opensnijden</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Opensnijden</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Het model met een vlak opensnijden, om naar binnen te kijken</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>Grond en schaduw</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>De grond met raster en de schaduw van het model tonen</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Spanningslijnen</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spanning</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Tonen waar het model het zwaarst belast is</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>Er is geen sectie verborgen</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>Er is geen vorig beeld</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>Het eenvoudige venster doet het zonder; bij Instellingen zit het hele</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Je eerste model in 3 minuten</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rondleiding</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Stap voor stap een model tekenen, controleren en snijden, in een leeg venster</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Hulp over wat onder de aanwijzer staat</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Opent de hulp waar ze over dit deel van het venster vertelt</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>Niet spiegelen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Alles laten zoals het was</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Geeft JSON, voor andere programma’s.</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Secties, verbindingen, grootte en massa van een model</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Of het één geheel is, staat, in elkaar kan en op de plaat past</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Of het sterk genoeg is: krachten, spanning en wat het kan dragen</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>De onderdelen om te snijden, in de eigen coördinaten van elke sectie</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Een afbeelding van het model; heeft een scherm nodig</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Hoe het in elkaar gaat, stap voor stap; heeft een scherm nodig</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>De benoemde waarden van een model, en wat ervan is gemaakt</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Een snijbestand en een oordeel voor elke regel van een tabel met waarden</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Alle soorten operaties, of de operaties van een model</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>De lussen waarin een vlak een mesh snijdt</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Secties die een mesh weergeven, staan en in elkaar kunnen</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Een model van een mesh in schijven</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Een model van vlakke platen met vingers langs de randen</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Onderdelen dicht bij elkaar op platen, of de stukken van een strook (.json)</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Speelt een script af van wat iemand in het venster doet</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Helemaal weggesneden door sleuven, dus er is geen onderdeel: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>Te groot voor de plaat, op eigen platen: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Te smal voor een nummer: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Een gat of inkeping smaller dan de snijbreedte wordt niet gesneden: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>Geen ruimte voor de nummers van alle verbindingen: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>De standaarduitvoer kon niet worden geschreven.</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>Niets te controleren: het model heeft geen secties.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>Secties buigen waar verbindingen een belasting delen, met eindige elementen; duurt seconden.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>De belasting blijft maanden: elk materiaal houdt alleen zijn aandeel van de sterkte daarvoor over.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>“%1” bestaat niet.</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF met lagen per doel</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Versie van een DXF-bestand: r2000 of r12 (r2000).</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>het model zelf</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Millimeter per eenheid van een FlatFab-bestand (25.4).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-code voor lasers</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>een LightBurn-project</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>de lichamen op hun plaats</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>de onderdelenlijst</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF op ware grootte</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Pagina’s van een PDF-bestand: sheet (één per plaat), of verdeeld over a4 of letter (sheet).</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>een afbeelding van de platen</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Hoe onderdelen in een STL- of 3MF-bestand liggen: in-place (op hun plaats), of flat (plat op hun platen) (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>de onderdelen om te printen</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>snijbestanden, op ware grootte</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>alles voor een werkplaats</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>er is geen scherm met OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>Het zoeken is voor het einde gestopt omdat deze computer bezet is: een andere keer kan een andere indeling geven.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Sleuven om te proberen</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Strook om erin te duwen</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Lat om te meten</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Te dicht bij de rand: de sleuf zou niets vasthouden</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Te dicht bij de rand: de sleuf zou niets vasthouden. B: naar binnen schuiven</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>%1 naar binnen geschoven. B: terugzetten</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontaal</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>verticaal</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>haaks op de rand</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>parallel aan de vorige</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Draait…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Teken de omtrek</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Nog niet verbonden</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>“%1” is %2, en dat kan hier niet.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>“%1” en een andere formule willen hier tegelijk iets anders.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Waar dit getal bij hoort, is er niet meer.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Maat</translation>
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
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>X van het midden</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>Y van het midden</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>Hoogte van letters</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Speling</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Snijbreedte</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Breedte van een plaat</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Hoogte van een plaat</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Diameter van het gereedschap</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Inloop van sleuven</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Noppen in sleuven</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Gevuld met</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Kracht langs X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Kracht langs Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Kracht dwars</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Trefpunt</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>‘%1’ kan hier niet: getallen die waarden volgen houden het op %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>‘%1’ kan hier niet: %2 volgt ‘%3’, en dat houdt het zoals het is.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>‘%1’ kan niet worden uitgerekend.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>‘%1’ is leeg, en dat kan hier niet.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>er is niet genoeg geheugen</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>een mesh: dit is vlak</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>bytes</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>items</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>de inhoudslijst ervan is beschadigd</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>dit item is beschadigd</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>dit item is versleuteld</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>er staat meer in dit bestand dan de inhoud ervan</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>dit item komt twee keer voor</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>dit item is op een onbekende manier ingepakt</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>dit item heeft een andere naam dan in de inhoudslijst</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>items erin delen hun bytes</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>dit item wordt uitgepakt veel te groot</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>onbeschadigde gzip-gegevens</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>de rest van de gzip-gegevens</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>een grotere plaat</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>een bestand heeft een naam nodig</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>dit bestand is alleen-lezen</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>deze map is alleen-lezen</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>een model</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>het is een map</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>deze waarde mag hier niet</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>niets gevonden, verwacht: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>gevonden: “%1”, verwacht: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>dit aantal is niet mogelijk</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>gevonden: een aantal van %1, verwacht: hoogstens %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>gevonden: %1 %3, verwacht: hoogstens %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>gemaakt met een nieuwere FlatFitFab</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>gemaakt met een nieuwere FlatFitFab: gevonden: formaat %1, verwacht: hoogstens %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>deze controlepunten vormen geen gesloten contour</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>deze controlepunten vormen geen gesloten contour: gevonden: %1, verwacht: %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>geen pad kan deze omtrek overal op een halve snijbreedte volgen</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>geen pad kan %1 overal op de helft van de snijbreedte van %2 mm volgen; maak de fijnste details van de contour vloeiender, of geef het materiaal een andere snijbreedte</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>door de snijbreedte valt een sleuf dicht</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 heeft een sleuf van %2 mm breed, die bij een snijbreedte van %3 mm dichtvalt</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>een %1-bestand</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>een %1-bestand van %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 of %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>kon niet worden geopend</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>kon niet worden geschreven</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>geen model, verwacht: %1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>het bestand eindigt hier, verwacht: %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>het bestand eindigt te vroeg</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>gevonden: “%1”, verwacht: een eindig getal</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>een getal is niet eindig</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>deze assen vormen geen assenstelsel, verwacht: twee van lengte 1 haaks op elkaar</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>deze contour omsluit geen oppervlakte</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>er is niets met nummer %1</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>dit verwijst naar iets wat niet bestaat</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>het nummer %1 is twee keer gebruikt, verwacht: een eigen nummer</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>dit nummer is twee keer gebruikt, verwacht: een eigen nummer</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>deze twee secties zijn bijna parallel en kunnen niet worden verbonden</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>deze contour kruist zichzelf</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>een gat zou de rand of een ander gat raken</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>er zouden te weinig punten overblijven om iets te omsluiten</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>de sleuven laten van geen enkele sectie iets over, dus er valt niets te snijden</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>er is nog geen sectie, dus er valt niets te snijden</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>geen van de plekken tussen de contouren kan worden overdekt (%1), dus er is geen huid</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>geen contouren kruisen elkaar bij hun rand, dus er is geen huid</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>er is geen opdracht “%1”</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>die opdracht bestaat niet</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>deze gebeurtenis heeft hier geen zin</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>“%1” wordt door deze versie niet ondersteund</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>dit wordt door deze versie niet ondersteund</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>dit was niet te berekenen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>“%1” kon niet worden uitgesneden: wat de sleuven ervan overlaten, was niet te berekenen</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>een sectie kon niet worden uitgesneden</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>het lichaam van “%1” was niet te berekenen</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>een lichaam was niet te berekenen</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>de markeringen op “%1” konden niet bij de rand worden afgesneden</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>de markeringen op een sectie konden niet bij de rand worden afgesneden</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>de secties van de operatie “%1” waren niet te berekenen</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>de secties van een operatie waren niet te berekenen</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>er ging iets mis binnen FlatFitFab (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>er ging iets mis binnen FlatFitFab</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>het is gestopt</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>de inhoud van dit bestand is beschadigd</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 stond een beetje scheef en is rechtgezet</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>een sectie stond een beetje scheef en is rechtgezet</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>de contour van %1 kruist zichzelf; de grootste lus is behouden</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>een contour kruist zichzelf; de grootste lus is behouden</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>een gat van %1 steekt buiten de contour uit en is weggelaten</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>een gat steekt buiten zijn contour uit en is weggelaten</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>een gat van %1 heeft geen oppervlakte en is weggelaten</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>een gat heeft geen oppervlakte en is weggelaten</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>gaten van %1 overlappen elkaar en zijn samengevoegd tot één gat</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>gaten overlappen elkaar en zijn samengevoegd tot één gat</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>een gat van %1 steekt buiten de contour uit en is eruit gesneden</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>een gat steekt buiten zijn contour uit en is eruit gesneden</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>regels na de laatste sectie zijn genegeerd</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>tekst na de laatste sectie is genegeerd, regels: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 kon niet worden gelezen en is weggelaten</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>een afbeelding of mesh is weggelaten</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 is weggelaten: %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>wat %1 toont, kon niet worden gelezen; de plaats ervan is behouden</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>een sjabloon kon niet worden gelezen; de plaats ervan is behouden</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved of scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>drie controlepunten per segment en nog één</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>minstens één lijn</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>twee verschillende plekken</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>een woord van letters en cijfers, één keer</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>de gegevens ervan ontbreken</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>een SHA-256 in 64 hexadecimale cijfers</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>een item met deze naam hoort hier niet</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>de gegevens van dit item kloppen niet met zijn naam, een SHA-256</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>dit item ontbreekt</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>niets in het document verwijst naar dit item</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point, patch of edge</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point, patch, edge of hanging</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>een breedte van 1 tot 10000 mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>een kracht [x, y, z] boven 0, hoogstens 1000000 N</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>een hoogte van 0 tot 10000 mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>een deel van zijn massa</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden of detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>iets anders dan gemaakt, elk exemplaar één keer</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>een id onder nextId</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>een aandeel boven 0, hoogstens 1</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>meer dan min de dikte</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>een breedte en een hoogte boven 0</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone of tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>drie controlepunten per segment, minstens 6</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom of top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>een richting met lengte 1</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs of none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>een aandeel van 0.05 tot 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>iets gewenst van twee secties, paren oplopend</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>een ouder die niet van haar eigen kind afstamt</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>minstens één materiaal</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>elk onderdeel één keer, in de volgorde van de secties</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>elke sectie één keer, in hun volgorde</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none, half, quarter of free</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh, picture of curves</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>niets: alleen meshes worden aangetrokken</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>een straal van 0.1 tot 1000 mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>het pad van een bestand</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>de SHA-256 van een blob, of een bestand</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>niets: een mesh ligt op geen sectie</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>een schaal van 1e-9 tot 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>een dekking van 0 tot 1</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals of groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>een formule die niet zo lang is</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice of switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>een naam zonder “=”, elk één keer</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>elke waarde één keer</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>een woord van letters en cijfers, elk één keer</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>elk getal één keer</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>een lengte van hoogstens 1000000 mm</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>een laatste controlepunt dat het eerste herhaalt</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>een getal</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>een aantal</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>een punt van twee getallen</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>drie controlepunten per segment en het eerste nog eens, minstens 7</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>minstens 1 kromme</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>een buffer met bytes</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>een buffer in het bestand</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>een lengte die zijn buffer heeft</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>een soort getallen die glTF heeft</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>zo veel waarden als zijn buffer heeft</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>zo veel getallen als daar horen</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>een knoop die niet binnen zichzelf ligt</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>een blok van een GLB-bestand</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>versie 2 van GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>een glTF-bestand</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>versie 2 van glTF</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>een object</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true of false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>een lijst</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>een getal boven 0, hoogstens 1000000</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>een getal van 0 tot 1000000</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>een geheel getal binnen zijn bereik</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>een tekst</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>een punt [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>een punt [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>een lijst van punten</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>een naam tussen aanhalingstekens of het einde van het object</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>een dubbele punt</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>een komma of het einde van de lijst</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>een escapereeks van JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>tekst in UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>het einde van de tekst tussen aanhalingstekens</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>nog een waarde na de komma</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>hoogstens 1024 niveaus</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>een kleiner bestand</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>het einde van het bestand</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>een waarde</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>elke sleutel van een object maar één keer</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>beide helften van een teken</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>een kleur zoals #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>een lijnbreedte in mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>een snelheid in mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>een regel G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>regels G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>de grootste S</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>breedte en hoogte in mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>een aandeel van 0 tot 1</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>een breedte van bruggetjes in mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>een lengte van aanlopen in mm</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>machines</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>een machine</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>driehoeken</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>hoekpunten</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>het staat in een andere map</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>een mesh</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>een geheel getal</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>minstens drie punten</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon of polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>minstens één hoek</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>een opgave voor het indelen van een strook</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>minstens één stuk</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>minstens drie hoeken van een vlak</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>het aantal hoekpunten</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>het aantal vlakken</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>de hoeken van een vlak</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>de afbeelding is beschadigd</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>de rest van de afbeelding</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>de afbeelding is hier beschadigd</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>een afbeelding als PNG, JPEG of WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>een afbeelding met minstens één pixel</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>niets schrijft naar deze pipe</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>er kwam 10 seconden lang niets uit</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>niets leest van deze pipe</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>het formaat</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element of end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii of binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>een type zoals float of int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>eerst een element</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>zo veel waarden als het bestand zegt te hebben</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y en z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>de lengte van een lijst</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>de schijf is vol</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>het aantal driehoeken</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>zo veel driehoeken als het bestand zegt te hebben</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet of endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex of endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>drie hoeken van een driehoek</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>lijnen; tekst moet eerst in paden worden omgezet</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>lijnen; een afbeelding moet eerst worden overgetrokken</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>lijnen, vormen of paden</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>een transformatie</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>groepen in groepen</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>plekken binnen een kilometer</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>paren van getallen</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>padgegevens</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>elementen en attributen</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>een SVG-tekening</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>een lengte</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punten</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>een afbeelding of een tekening</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>er staat geen 3D-model in dit bestand</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>een 3D-model</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>een eenheid zoals millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>twaalf getallen</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>een object dat zichzelf niet bevat</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n sectie stond een beetje scheef en is rechtgezet.</numerusform>
            <numerusform>%n secties stonden een beetje scheef en zijn rechtgezet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n contour kruiste zichzelf; de grootste lus is behouden.</numerusform>
            <numerusform>%n contouren kruisten zichzelf; van elk is de grootste lus behouden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n gat stak buiten zijn contour uit en is weggelaten.</numerusform>
            <numerusform>%n gaten staken buiten hun contour uit en zijn weggelaten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n gat had geen oppervlakte en is weggelaten.</numerusform>
            <numerusform>%n gaten hadden geen oppervlakte en zijn weggelaten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Gaten van %n sectie overlapten elkaar en zijn samengevoegd.</numerusform>
            <numerusform>Gaten van %n secties overlapten elkaar en zijn samengevoegd.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n gat stak buiten zijn contour uit en is eruit gesneden.</numerusform>
            <numerusform>%n gaten staken buiten hun contour uit en zijn eruit gesneden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Tekst na de laatste sectie is op %n plek genegeerd.</numerusform>
            <numerusform>Tekst na de laatste sectie is op %n plekken genegeerd.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>%n afbeelding of mesh kon niet worden gelezen en is weggelaten.</numerusform>
            <numerusform>%n afbeeldingen of meshes konden niet worden gelezen en zijn weggelaten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>%n sjabloon kon niet worden gelezen; de plaats ervan is behouden.</numerusform>
            <numerusform>%n sjablonen konden niet worden gelezen; hun plaatsen zijn behouden.</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>de map is niet te gebruiken</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>het is in een ander venster geopend</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>plekken waar een lijn zichzelf mag kruisen</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>de gegevens ervan zijn beschadigd</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>een mesh met minstens één driehoek</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>een rand met drie of meer vlakken</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>een mesh waarvan twee vlakken bij een rand samenkomen</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>wat ‘%1’ moest volgen, is nu een gewoon getal</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n getal volgt niet meer wat ervoor was getypt.</numerusform>
            <numerusform>%n getallen volgen niet meer wat ervoor was getypt.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>een afbeelding</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>een tekening</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>elke machine één keer, in hun volgorde</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>reststukken</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>een omtrek vanaf 0, 0 die zichzelf niet kruist</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>dikten</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>wat een plaat kan hebben</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materialen</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>de omtrek is open: de uiteinden liggen %1 mm uit elkaar</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>coördinaten tot 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>geplaatste objecten</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>Cirkel</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellips</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Hoekstraal</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Veelhoek</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Zijden</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Ster</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Binnendiameter</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Punten</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Slobgat</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>Niet te maken</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF, op ware grootte</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, één per plaat</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF voor oude programma’s, R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>FlatFitFab-modellen</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code voor GRBL-lasers</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code, één per plaat</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>glTF-meshes</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>LightBurn-project</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, één per plaat</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>OBJ-meshes</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, lichamen op hun plaats</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, huid als mesh</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>OFF-meshes</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Onderdelenlijst voor rekenbladen</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, één pagina per plaat</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, verdeeld over A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, verdeeld over Letter</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>PLY-meshes</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Afbeelding van de platen</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Afbeeldingen, één per plaat</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>STL-meshes</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, lichamen op hun plaats</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, huid als mesh</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, lichamen plat liggend</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG, op ware grootte</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, één per plaat</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>3MF-meshes</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, lichamen op hun plaats</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, lichamen plat liggend</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Alles voor de werkplaats, ingepakt</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Alles voor de werkplaats, in een map</translation>
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
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; maakt het ongedaan.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>Niets verplaatst: waar %1 en %2 samenkomen, zijn er geen twee sleuven die de diepte delen.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>Niets gewijzigd: %1 en %2 zijn zo niet te verbinden.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>Niets omgedraaid: de sleuven van %1 en %2 kunnen niet naar de andere kant openen.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>Niets ingekort: %1 zit niet in %2, of er zou niets van overblijven.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Beweeg om de snede te verschuiven, laat los om die daar te laten. &lt;kbd&gt;Esc&lt;/kbd&gt; zet die terug.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>Op een vlak dat je van opzij ziet, kun je niet tekenen: draai het beeld om verder te gaan.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Lijn weggegooid: de sectie ervan bestaat niet meer.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>Niets getekend: van deze lijn is geen sectie te maken. Teken die als één open lus.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>Niets getekend: alles ligt onder de grond, waar het wordt afgesneden.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>Geen gat gemaakt: het moet binnen %1 liggen en die in één stuk laten.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>Het gat steekt buiten de rand van %1 uit en is eruit gesneden.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>Het gat raakte andere in %1; ze zijn nu één gat.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>Gaten van %1 buiten de nieuwe contour zijn weggelaten.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken een sectie op de grond, in één haal. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken een sectie op het voorvlak, in één haal. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken een sectie op het zijvlak, in één haal. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken een sectie parallel aan %1, in één haal. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Teken de nieuwe contour van %1, in één haal. &lt;kbd&gt;Esc&lt;/kbd&gt; behoudt de oude.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken een gat in %1, in één haal. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken een gat: begin op de sectie die het krijgt. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>Niets geïmporteerd: geen lijn in %1 vormt een gesloten omtrek. Graveren kan wel.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n omtrek van %1 paste niet en is weggelaten.</numerusform>
            <numerusform>%n omtrekken van %1 pasten niet en zijn weggelaten.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 overgeslagen; %3.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 en %3 overgeslagen; %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n tekst</numerusform>
            <numerusform>%n teksten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n afbeelding</numerusform>
            <numerusform>%n afbeeldingen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>%n lijn is gelezen</numerusform>
            <numerusform>%n lijnen zijn gelezen</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 ligt schuin op %1: verplaats het eerst naar het vlak van %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 heeft %n omtrek, en dat is te veel: trek het grover over, of maak het eerst gladder.</numerusform>
            <numerusform>%1 heeft %n omtrekken, en dat is te veel: trek het grover over, of maak het eerst gladder.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Niets overgetrokken: geen deel van %1 ligt aan die kant van de drempel.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: sleep vanuit het midden naar buiten; een klik maakt er een van de gewone grootte.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: sleep vanuit het midden naar buiten om de vorm uit %2 te snijden.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om het zo groot te maken; &lt;kbd&gt;Shift&lt;/kbd&gt; houdt beide zijden gelijk. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Teken de eerste sectie: druk, teken de vorm in één haal en laat los.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Sleep om het beeld te draaien; &lt;kbd&gt;Shift&lt;/kbd&gt; slepen selecteert een groep.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Sleep vanuit %1 naar buiten om er een sectie dwars op te tekenen; klik om te selecteren.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Klik om %1 te selecteren. Sleep om het beeld te draaien: op een sectie die je van opzij ziet, kun je niet tekenen.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Sleep om de snede door het model te verplaatsen; &lt;kbd&gt;Esc&lt;/kbd&gt; sluit die.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Klik om probleem %1 te selecteren.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Sleep om het punt te verplaatsen; &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt een hoek, pijltjestoetsen verplaatsen 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Sleep om de kromme te buigen; &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt een hoek, &lt;kbd&gt;Shift&lt;/kbd&gt; houdt de richting vast.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Dubbelklik om hier een punt toe te voegen; sleep om de contour te buigen.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Klik om de verbinding van %1 en %2 te selecteren.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Sleep om de sleuf van %1 dieper en die van %2 ondieper te maken; klik om de verbinding te selecteren.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Sleep om de sleuf van %1 dieper en die van %2 ondieper te maken; pijltjestoetsen verplaatsen 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Sleep om het gewicht van %1 op %2 te verplaatsen; klik om het te selecteren.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Pijltjestoetsen verplaatsen het gewicht van %1 op %2 met 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; en &lt;kbd&gt;−&lt;/kbd&gt; wijzigen het, &lt;kbd&gt;Del&lt;/kbd&gt; verwijdert het.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Sleep om de duw van %1 op %2 te verplaatsen, sleep de punt om te draaien; klik om te selecteren.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Pijltjestoetsen verplaatsen de duw van %1 op %2 met 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; en &lt;kbd&gt;−&lt;/kbd&gt; wijzigen die, &lt;kbd&gt;Del&lt;/kbd&gt; verwijdert die.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 is gemaakt door %2: klik om alles te bewerken, klik nog eens voor alleen deze.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Klik om alleen %1 te selecteren; sleep naar buiten om er een sectie dwars op te tekenen.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Sleep een ronde greep om het begin of einde van %1 te verplaatsen; klik op een sectie om die te selecteren.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Sleep om het begin van %1 te verplaatsen; klik om het te typen.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Sleep om het einde van %1 te verplaatsen; klik om het te typen.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Klik om van voren te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Klik om van achteren te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Klik om van links te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Klik om van rechts te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Klik om van boven te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Klik om van onderen te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Klik om op deze rand te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Klik om op deze hoek te kijken; sleep om het beeld te draaien.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Sleep om het beeld te draaien; het wiel zoomt.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om het hier te laten: de sleuf van %1 krijgt %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Klik op een plek op een sectie om %1 daar te zetten. &lt;kbd&gt;Esc&lt;/kbd&gt; stopt.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Druk op een sectie en sleep in de richting van de duw. &lt;kbd&gt;Esc&lt;/kbd&gt; stopt.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Druk op een sectie en sleep om eraan te trekken en te zien wat er gebeurt; er wordt niets bewaard.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Laat los om te laten gaan: er wordt niets bewaard.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Sleep om te verplaatsen. &lt;b&gt;Klik&lt;/b&gt; om te selecteren.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>Sleep de punt om de duw te draaien; een langere pijl duwt harder.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Laat los om het gewicht hier te zetten. &lt;kbd&gt;Esc&lt;/kbd&gt; zet het terug.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Laat los om hier te duwen. &lt;kbd&gt;Esc&lt;/kbd&gt; zet de duw terug.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>Geen gewicht toegevoegd: klik op een sectie.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>Geen duw toegevoegd: druk op een sectie.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>De kopie van %1 draagt dit ook; via &lt;i&gt;Eigenschappen&lt;/i&gt; kun je het tot deze beperken.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>%n kopie van %1 draagt dit ook; via &lt;i&gt;Eigenschappen&lt;/i&gt; kun je het tot deze beperken.</numerusform>
            <numerusform>%n kopieën van %1 dragen dit ook; via &lt;i&gt;Eigenschappen&lt;/i&gt; kun je het tot deze beperken.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Het gewicht blijft waar het is: daar zou het naast %1 zitten.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>De duw blijft waar die is: daar zou die naast %1 zitten.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Sleep om in te stellen hoe ver %1 sjablonen aantrekt.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Laat los om %1 sjablonen vanaf %2 te laten aantrekken. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken op de sectie die je wilt graveren, of klik erop. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Sleep om een lijn op %1 te tekenen; &lt;kbd&gt;Shift&lt;/kbd&gt; houdt die recht. Klik om tekst te plaatsen.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om de lijn te behouden. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 wordt op de voorkant gegraveerd, de enige kant waar de laser bij kan; het beeld is daarheen gedraaid.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>Niets gegraveerd: dat ligt niet op %1.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>Het teken “%1” is niet te graveren.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Sleep van de ene plek naar de andere om te meten; met &lt;kbd&gt;Ctrl&lt;/kbd&gt; klikt niets vast. &lt;kbd&gt;Esc&lt;/kbd&gt; stopt.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ga naar de tweede plek. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Klik of sleep om opnieuw te meten. &lt;kbd&gt;Esc&lt;/kbd&gt; wist het.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Sleep langs iets waarvan je de lengte weet; het hele model volgt. &lt;kbd&gt;Esc&lt;/kbd&gt; stopt.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Typ de gewenste lengte; &lt;kbd&gt;Enter&lt;/kbd&gt; schaalt het hele model. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>Zo groot of klein kan het model niet worden.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>Zo ver is het model niet te schalen: %1 zou buiten de grenzen komen.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Klik op de sectie waarin je wilt spiegelen; sleep om het beeld te draaien. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: er een cirkel van maken</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: er een ellips van maken</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: lijnen recht maken</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: hoeken recht maken</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: sleuf van de rand af schuiven</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>Nu een cirkel.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>Nu een ellips.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Lijnen recht gemaakt.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Hoeken recht gemaakt.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Van de rand af geschoven.</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 blijft waar het is getekend: naar binnen geschoven zou de sleuf %2 in stukken snijden. Teken dwars over de rand, niet erlangs.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Laat los om %1 hier te laten beginnen: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Laat los om %1 hier te laten eindigen: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Sleep vanuit een sectie naar buiten om er met de pen dwars op te tekenen; sleep hier om het beeld te draaien. &lt;kbd&gt;Esc&lt;/kbd&gt; legt de pen weg.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Sleep vanuit %1 naar buiten om er met de pen dwars op te tekenen; klik om te selecteren.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Klik om het eerste punt te zetten, sleep om te buigen. &lt;kbd&gt;Esc&lt;/kbd&gt; legt de pen weg.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Klik om een punt te zetten, sleep om te buigen; &lt;kbd&gt;Enter&lt;/kbd&gt; sluit, &lt;kbd&gt;Backspace&lt;/kbd&gt; haalt er een weg.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Klik om een punt te zetten, sleep om te buigen; &lt;kbd&gt;Enter&lt;/kbd&gt; sluit, &lt;kbd&gt;Backspace&lt;/kbd&gt; haalt er een weg. Met &lt;kbd&gt;Ctrl&lt;/kbd&gt; klikt niets vast.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>De contour kruist zichzelf: &lt;kbd&gt;Enter&lt;/kbd&gt; behoudt de grootste lus, &lt;kbd&gt;Backspace&lt;/kbd&gt; haalt een punt weg.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Sleep om te buigen; &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt een hoek, &lt;kbd&gt;Shift&lt;/kbd&gt; houdt de richting vast.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Sleep om het punt te verplaatsen; met &lt;kbd&gt;Ctrl&lt;/kbd&gt; klikt het niet vast, &lt;kbd&gt;Shift&lt;/kbd&gt; houdt de richting vast.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Sleep de greep om te buigen; &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt een hoek.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Klik om de contour te sluiten; sleep om het punt te verplaatsen.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; zet het punt, &lt;kbd&gt;Tab&lt;/kbd&gt; gaat naar het volgende getal. &lt;kbd&gt;Esc&lt;/kbd&gt; sluit de balk.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Niet gesloten: de punten omsluiten nog niets.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Er is nog een contour open: &lt;kbd&gt;Enter&lt;/kbd&gt; sluit die, &lt;kbd&gt;Esc&lt;/kbd&gt; haalt die weg.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Tot nu toe: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Tot nu toe: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; voert het uit.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; voert het uit. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Laat los om het hier te laten. &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt een hoek, &lt;kbd&gt;Shift&lt;/kbd&gt; houdt de richting vast.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Laat los om het zo te laten. &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt een hoek, &lt;kbd&gt;Shift&lt;/kbd&gt; houdt de richting vast.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om het zo te laten. &lt;kbd&gt;Ctrl&lt;/kbd&gt; maakt hoeken aan de uiteinden. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>De contour zou zichzelf hier kruisen; ze blijft zoals ze net daarvoor was.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Een gat zou hier de rand of een ander gat raken; het blijft zoals het net daarvoor was.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>%1 zou hier bij de grond helemaal worden afgesneden; alles blijft zoals het was.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>Niets verwijderd: een contour heeft minstens twee punten nodig.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om alles te selecteren wat er helemaal binnen ligt. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om de punten erbinnen te selecteren. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 houdt haar hoek met %2. Maak de sectie vrij om haar te draaien zoals je wilt.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 zit niet op een andere sectie en heeft er dus geen hoek mee.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 kan niet op %2 zitten, want %2 zit op %1.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 en %2 raken elkaar niet: verplaats eerst de ene dwars door de andere.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Klik op de sectie waarop je %1 wilt zetten. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Sleep om het beeld te draaien; &lt;kbd&gt;Spatie&lt;/kbd&gt; speelt af, &lt;kbd&gt;←&lt;/kbd&gt; en &lt;kbd&gt;→&lt;/kbd&gt; gaan stap voor stap. &lt;kbd&gt;Esc&lt;/kbd&gt; sluit de stappen.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>Het model is gewijzigd, dus zijn de stappen gesloten.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Sleep verder tot buiten %1; de sleuf eindigt bij de rand. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Sleep verder tot buiten %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; laat de sleuf zoals je die tekent. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>Het beeld draait: teken meteen verder, of wacht tot het stilstaat.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Teken de omtrek: verlaat de grijze zone waar die moet beginnen. Laat hier los om te annuleren.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Teken de contour, laat los om die te sluiten. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om de sectie te maken. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om het gat in %1 te snijden. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om %1 deze contour te geven. &lt;kbd&gt;Esc&lt;/kbd&gt; behoudt de oude.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om de sectie te maken, gespiegeld in de sleuf. Houd &lt;kbd&gt;Shift&lt;/kbd&gt; ingedrukt om alleen deze kant te houden. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om de sectie te maken, gespiegeld. Zonder &lt;kbd&gt;Shift&lt;/kbd&gt; blijft alleen deze kant. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om %1 deze contour te geven, gespiegeld in de sleuf. &lt;kbd&gt;Shift&lt;/kbd&gt; doet het omgekeerde.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Laat los&lt;/b&gt; om de sectie te maken, gespiegeld in de verticaal. Houd &lt;kbd&gt;Shift&lt;/kbd&gt; ingedrukt om alleen deze kant te houden.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Volg de blauwgroene kromme om op %1 vast te klikken; houd &lt;kbd&gt;Ctrl&lt;/kbd&gt; ingedrukt om die los te laten. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; neemt die helemaal over.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Shift+Enter: hele hulplijn overnemen</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>De sleuf raakt geen hulplijn, dus er is er geen om helemaal over te nemen.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>Niets getekend: de sleuf kwam nooit buiten %1. Begin binnenin en sleep over de rand; &lt;kbd&gt;O&lt;/kbd&gt; tekent gaten, &lt;kbd&gt;E&lt;/kbd&gt; graveert.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>Niets getekend: de lijn is te kort om iets te omsluiten.</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Niets getekend: een lijn van minder dan %1 geldt als een uitschieter, tenzij ze een lus sluit.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>Niets getekend: de lijn gaat heen en weer en omsluit niets.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>Niets getekend: de lijn kruist zichzelf, en geen lus ervan is groot genoeg.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 is niet gespiegeld: de twee helften zouden elkaar niet raken.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>De contour kruist zichzelf; de grootste lus is behouden.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 is gespiegeld; wat de as overstak en terugkwam, is weggelaten.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 komt niet tot in de sleuf: niets verbindt het met %2.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 is naast de sleuf getekend, kreeg een hals en is bij de grond recht afgesneden.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 is naast de sleuf getekend en kreeg een hals die erin steekt.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 is niet symmetrisch: de helften verschillen.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sleep een pijl om %1 te verplaatsen, een ring om te draaien, een blokje om te schalen; of typ getallen. &lt;kbd&gt;Esc&lt;/kbd&gt; verbergt de grepen.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Sleep om te verplaatsen; &lt;kbd&gt;Shift&lt;/kbd&gt; blijft in één richting.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Sleep om te draaien.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Sleep om te schalen.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om het zo te laten. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 is vergrendeld.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Zo ver is %1 niet te verplaatsen of te schalen.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sleep langs iets in %1 waarvan je de lengte weet; &lt;kbd&gt;Shift&lt;/kbd&gt; blijft in acht richtingen. &lt;kbd&gt;Esc&lt;/kbd&gt; stopt.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Typ hoe lang dat is; &lt;kbd&gt;Enter&lt;/kbd&gt; maakt %1 zo groot. &lt;kbd&gt;Esc&lt;/kbd&gt; wist de lijn.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Geen vlak stuk van %1 is groot genoeg voor een sectie: maak het eerst groter.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Het heeft meer dan %1 vlakke stukken: kies minder vlakken.</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Een plaat van %1 is niet te vouwen: kies een materiaal van %2 of minder.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Vouw langs de geritste lijnen en verbind dan de randen met hetzelfde nummer: %n naad.</numerusform>
            <numerusform>Vouw langs de geritste lijnen en verbind dan de randen met hetzelfde nummer: %n naden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Klik op de sectie die je wilt verplaatsen of draaien, of sleep die. &lt;kbd&gt;Esc&lt;/kbd&gt; verbergt de grepen.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Sleep een pijl om te verplaatsen, een ring om te draaien, een blokje om te schalen; of typ getallen. &lt;kbd&gt;Esc&lt;/kbd&gt; verbergt de grepen.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Sleep om %1 te verplaatsen; klik om te selecteren.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Sleep om te verplaatsen; &lt;kbd&gt;Ctrl&lt;/kbd&gt; laat een kopie achter, &lt;kbd&gt;Shift&lt;/kbd&gt; blijft in één richting.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Sleep om te draaien; &lt;kbd&gt;Ctrl&lt;/kbd&gt; laat een kopie achter.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Sleep om te schalen; &lt;kbd&gt;Ctrl&lt;/kbd&gt; laat een kopie achter.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om het zo te laten. &lt;kbd&gt;Ctrl&lt;/kbd&gt; laat een kopie achter, &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Laat los om hier een kopie achter te laten. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; laat het zo. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; maakt %n kopie zoals deze. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</numerusform>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; maakt %n kopieën zoals deze, elk een stap verder. &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Een voorinstelling heeft een naam nodig, zonder “=” en zonder spaties aan het begin of einde.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Anderen kunnen nog geen waarde aanpassen, dus er is niets te bewaren.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>Er is geen voorinstelling met de naam “%1”.</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>Dit is wat anderen zien. Sla het bestand op en geef het ze; zo gaat het open.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n getal dat ervan was gemaakt, is nu een gewoon getal.</numerusform>
            <numerusform>%n getallen die ervan waren gemaakt, zijn nu gewone getallen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>%n voorinstelling die niets anders instelt, is ook weg.</numerusform>
            <numerusform>%n voorinstellingen die niets anders instellen, zijn ook weg.</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>Er zijn geen smallere bereiken gevonden waarin het model het houdt.</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Beweeg om het beeld te draaien, laat los om te stoppen.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Beweeg om het beeld te verschuiven, laat los om te stoppen.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Beweeg omhoog om in te zoomen, omlaag om uit te zoomen; laat los om te stoppen.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>Niets gewijzigd: dat kan hier niet.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 is vergrendeld. Ontgrendel dit in het Overzicht om het te wijzigen.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 is gemaakt door %2: bewerk de bron, of maak deze los.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>Er zou niets van %1 overblijven; alles blijft zoals het was.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 is bij de grond recht afgesneden.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1 viel uit elkaar toen het bij de grond recht werd afgesneden; het grootste stuk is behouden.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>Niets geplakt: in wat is gekopieerd, zitten geen secties en geen afbeelding.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>Niets gekopieerd: het model is al symmetrisch.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>Niets verwijderd: een verbinding is waar twee secties samenkomen. Verwijder een van de twee, of kies de soort “Geen”.</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>‘%1’ is nu wat is ingesteld, in plaats van wat het was.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Teken eerst een sectie: er is nog niets om te spiegelen.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Teken eerst een sectie: er is nog niets om te herhalen of te verdelen.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n rand heeft geen vingers: de platen komen daar te vlak of te scherp samen, of de rand is te kort. Minder vlakken helpen, of in plaats daarvan schijven.</numerusform>
            <numerusform>%n randen hebben geen vingers: de platen komen daar te vlak of te scherp samen, of de randen zijn te kort. Minder vlakken helpen, of in plaats daarvan schijven.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Voegt een spiegelbeeld van de selectie toe. &lt;kbd&gt;Enter&lt;/kbd&gt; spiegelt; &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Wat je aan de ene kant verandert, verandert ook aan de andere. &lt;kbd&gt;Enter&lt;/kbd&gt; spiegelt; &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Maakt beide kanten één keer gelijk; daarna staat elke kant op zichzelf. &lt;kbd&gt;Enter&lt;/kbd&gt; spiegelt; &lt;kbd&gt;Esc&lt;/kbd&gt; annuleert.</translation>
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
        <translation>Glas water</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Vork</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Mes</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Lepel</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Boek</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Bloempot</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Een vlak is weggelaten: een hoek ervan bestaat niet.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>%n vlak is weggelaten: een hoek ervan bestaat niet.</numerusform>
            <numerusform>%n vlakken zijn weggelaten: een hoek ervan bestaat niet.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Een vlak is weggelaten: de plaats van een hoek is geen getal.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>%n vlak is weggelaten: de plaats van een hoek is geen getal.</numerusform>
            <numerusform>%n vlakken zijn weggelaten: de plaats van een hoek is geen getal.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Een vlak is weggelaten: het heeft een hoek dubbel.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>%n vlak is weggelaten: het heeft een hoek dubbel.</numerusform>
            <numerusform>%n vlakken zijn weggelaten: ze hebben een hoek dubbel.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Een vlak is weggelaten: het is er dubbel.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>%n vlak is weggelaten: het is er dubbel.</numerusform>
            <numerusform>%n vlakken zijn weggelaten: ze zijn er dubbel.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Een vlak keek de verkeerde kant op en is omgedraaid.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n vlak keek de verkeerde kant op en is omgedraaid.</numerusform>
            <numerusform>%n vlakken keken de verkeerde kant op en zijn omgedraaid.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>Het oppervlak heeft een gat: een rand staat open.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>Het oppervlak heeft gaten: %n rand staat open.</numerusform>
            <numerusform>Het oppervlak heeft gaten: %n randen staan open.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>Bij een rand komen meer dan twee vlakken samen.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>Bij %n rand komen meer dan twee vlakken samen.</numerusform>
            <numerusform>Bij %n randen komen meer dan twee vlakken samen.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>Bij een rand komen vlakken samen die niet dezelfde kant op kunnen kijken.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>Bij %n rand komen vlakken samen die niet dezelfde kant op kunnen kijken.</numerusform>
            <numerusform>Bij %n randen komen vlakken samen die niet dezelfde kant op kunnen kijken.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>Het was binnenstebuiten en is omgekeerd.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Een onderbreking in de snede is met een vloeiende kromme gesloten.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n onderbreking in de snede is met een vloeiende kromme gesloten.</numerusform>
            <numerusform>%n onderbrekingen in de snede zijn met vloeiende krommen gesloten.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>Vlak</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>Hoe</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 zegt niet hoe groot het is in mm of inch; het reststuk wordt genomen als %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: de omtrek kruist zichzelf; het grootste stuk ervan wordt genomen, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: lijnen snijden het reststuk in stukken; het grootste wordt genomen, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: er zijn open lijnen in het reststuk; wat ze gesloten zouden omsluiten, blijft vrij.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>Aantal</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Lijn</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Inclusief de secties die er al zijn</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>Stap X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Stap Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Stap Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Reeks</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Herhaalt secties langs een lijn door de ruimte.</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>Reeks van %1</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secties</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Klik op de secties die je wilt herhalen.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Overgang</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Maakt tussenvormen tussen secties.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>Overgang van %1</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Klik op de secties van de overgang, op volgorde.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Langs</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Klik op de sectie waar het langs moet lopen.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Aantal per tussenruimte</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Plaatsing</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Verloop</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gelijkmatig</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>Traag aan de einden</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Koppeling</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Zoals getekend</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Omgekeerd</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Rondes</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Groei</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Maat van een kopie</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Maat variëren ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Hoek variëren ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startgetal</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Kleinste</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Hoogstens</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Vertakking</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Laat kopieën van een sectie met alles erop groeien in plaats van haar kinderen, keer op keer.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>Vertakking van %1</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wortel</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Klik op de sectie die zich vertakt.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Gehouden door</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Klik op de sectie die haar vasthoudt: kopieën worden net zo vastgehouden.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Kinderen</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Klik op de aanhangende secties die kopieën moeten vervangen.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Verdeelt een te grote sectie in cellen die bij elkaar blijven.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>Raster van %1</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sectie</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Klik op de sectie die je wilt verdelen.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Passend op mijn plaat</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellen</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Celbreedte</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Celhoogte</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Recht met koppelstukken</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Puzzel</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Randen</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Koppelstukken per rand</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Maat koppelstuk</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Speling</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Snippers samenvoegen onder</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Kant</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vooruit</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Achteruit</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Even diep binnenin</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>Van elke kopie ligt dezelfde lengte binnen de andere sectie</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Rij</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Herhaalt een sectie in een rij langs een andere.</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>Rij van %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Soort</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cirkel</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Ster</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Tandwiel</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Gaten</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Getekende sector</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Sectoren</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Buitenstraal</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Binnenstraal</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Tand</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rond</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Recht</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapezium</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>Toepassen op</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>Cirkel van %1</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>Ster van %1</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>Gaten van %1</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>Rozet van %1</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>Tandwiel van %1</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radiaal</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Maakt van een sectie een cirkel, ster of tandwiel, of snijdt zulke gaten erin.</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Klik op de sectie die je wilt vormen.</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Klik op de sectie die je wilt herhalen.</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Hele tak</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Met alles wat eraan vastzit</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Herhalen op</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Afstand</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Van</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Tot</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Schaal</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nee</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Naar plaatselijke dikte</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richting</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Hele sectie</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>Langs de sleuf</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Sterkte</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>Niet onder</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Buiten</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Binnen</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Hoek met rand</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>Helemaal rond</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Rondom</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Herhaalt een sectie rondom de contour van een andere.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>Waaier van %1</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Vlakken</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>dwars op X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>dwars op Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>dwars op Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>dwars op X en Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>dwars op X en Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>dwars op Y en Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>langs een kromme</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schijven</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>In elke richting</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschuiving</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>Van alle vlakken, als deel van hun afstand</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Kleinste stuk</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>In mm²; kleinere stukken worden weggelaten, en ook stukken die overal dun zijn</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Hol</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Er blijft alleen een wand langs de contour over</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Snijdt een mesh in secties die de vorm volgen.</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Klik op de sectie waarvan het de contour moet volgen.</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Klik op de secties waarvoor het geldt.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Geldt voor</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Hele model</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selectie</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeling</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Herhaalt alles wat aan de ene kant is getekend aan de andere kant.</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Klik op de sectie waarin je wilt spiegelen.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Vlak</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>Vlak van een sectie</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>Bij het vlak verbinden</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Herhaalt alles wat één keer is getekend rond een as.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>As</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Klik op de twee secties waarvan de sleuf de as is.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticaal</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Sleuf</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>zoals een sectie</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>rond Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>rond X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>rond Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Zoals</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Klik op de sectie waaraan ze evenwijdig moeten zijn.</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>on</source>
        <translation>aan</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
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
        <source>%1 makes nothing yet: choose its “%2”.</source>
        <extracomment>%1 is the name of an operation, %2 what it asks for: &quot;Along&quot;</extracomment>
        <translation>%1 maakt nog niets: kies eerst “%2”.</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 is de sectie “%2” kwijt, die is verwijderd. Er wordt niets gemaakt tot je een andere kiest.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 maakt niets: de secties kruisen elkaar niet.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 maakt niets: er is geen ruimte binnen het bereik.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 heeft niets te verdelen: de sectie past in één cel.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 was niet te berekenen: de secties ontbreken.</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 is gestopt bij 1 sectie.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 is gestopt bij %n sectie.</numerusform>
            <numerusform>%1 is gestopt bij %n secties.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 sectie van %1 is weggelaten, want er is niets om die vast te houden.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%n sectie van %1 is weggelaten, want er is niets om die vast te houden.</numerusform>
            <numerusform>%n secties van %1 zijn weggelaten, want er is niets om ze vast te houden.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 maakt niets: het sjabloon is weg of het bestand ervan ontbreekt.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 klein stuk van %1 is weggelaten.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%n klein stuk van %1 is weggelaten.</numerusform>
            <numerusform>%n kleine stukken van %1 zijn weggelaten.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: print op 100&#x202f;%</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Plaat %1, pagina %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Losmaken</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <extracomment>keys, as they are labelled on a keyboard of the country, in menus: &quot;Ctrl+Shift+S&quot;</extracomment>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
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
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Ins</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>PgUp</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgDn</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
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
        <translation>Spatie</translation>
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
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Omlaag</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Gestopt: %1. Wordt opnieuw berekend als het model verandert.</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>Niet te berekenen: %1. Reden: %2.</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>wat er aan problemen te doen is</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Berekenen: %1…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>Berekenen: %1… %2&#x202f;%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>de verbindingen en sleuven</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>de controles</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>de montagevolgorde</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>of het houdt</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>hoeveel het draagt als secties buigen</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>hoeveel elke plek van een sectie draagt</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>de huid</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>hoe onderdelen op de platen liggen</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>wat magneten van sjablonen maken</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>wat onderdelen vrijmaakt die elkaar blokkeren</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>Snijden instellen</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>%1 bewerken</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Materiaal van %1 wijzigen</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Materiaal van %n sectie wijzigen</numerusform>
            <numerusform>Materiaal van %n secties wijzigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>%1 invoegen</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Op de grond zetten</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Grondvlak van %1 verbreden</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Voet aan %1 toevoegen</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 en %2 verbinden</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>%1 naar %2 verplaatsen</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>%n sectie naar %1 verplaatsen</numerusform>
            <numerusform>%n secties naar %1 verplaatsen</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sleuven van %1 omdraaien</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 over %2 verplaatsen</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Montage mogelijk maken</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 met een voet ondersteunen</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 tot de grond verlengen</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>%n sectie tot de grond verlengen</numerusform>
            <numerusform>%n secties tot de grond verlengen</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>Dikte van %1 op %2 zetten</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 op 90° draaien</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 breder maken waar het zwak is</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: sleuven omdraaien</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: trefpunt → %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: automatische instellingen herstellen</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: soort → kruisverbinding</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: soort → verlengde kruisverbinding</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: soort → pengat</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: soort → lippen</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: soort → geen</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 tot %2 inkorten</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 opnieuw tekenen</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Gat in %1 tekenen</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 tekenen</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>%1 importeren</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 overtrekken</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Vorm van %1 wijzigen</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>%1 op %2 zetten</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Gewicht op %1 verplaatsen</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Gewicht op %1 instellen</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Gewicht hernoemen tot %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Gewicht verwijderen</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Tegen %1 duwen</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Duw op %1 verplaatsen</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Duw op %1 draaien</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Duw op %1 instellen</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Duw hernoemen tot %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Duw verwijderen</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Belasting op %1 spreiden</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ook de kopieën van %1 belasten</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>De kopieën van %1 niet belasten</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sjablonen naar %1 trekken</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Sjablonen naar %n sectie trekken</numerusform>
            <numerusform>Sjablonen naar %n secties trekken</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sjablonen van %1 loslaten</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Sjablonen van %n sectie loslaten</numerusform>
            <numerusform>Sjablonen van %n secties loslaten</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 markeren</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Markering van %1 wijzigen</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Markering van %1 verwijderen</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Model schalen tot %1&#x202f;%</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Van %1 een cirkel maken</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Van %1 een ellips maken</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Van het gat in %1 een cirkel maken</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Van het gat in %1 een ellips maken</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Lijnen van %1 recht maken</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Hoeken van %1 recht maken</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 van de rand af schuiven</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punt aan %1 toevoegen</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punt van %1 verwijderen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>%n punt van %1 verwijderen</numerusform>
            <numerusform>%n punten van %1 verwijderen</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Greep van %1 verplaatsen</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Contour van %1 buigen</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punt van %1 verplaatsen</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>%n punt van %1 verplaatsen</numerusform>
            <numerusform>%n punten van %1 verplaatsen</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Punt van %1 wijzigen</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>%n punt van %1 wijzigen</numerusform>
            <numerusform>%n punten van %1 wijzigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 verplaatsen</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>%n sectie verplaatsen</numerusform>
            <numerusform>%n secties verplaatsen</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 draaien</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>%n sectie draaien</numerusform>
            <numerusform>%n secties draaien</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 schalen</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>%n sectie schalen</numerusform>
            <numerusform>%n secties schalen</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 kopiëren</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>%n sectie kopiëren</numerusform>
            <numerusform>%n secties kopiëren</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kopie van %1 spiegelen</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Kopie van %n sectie spiegelen</numerusform>
            <numerusform>Kopieën van %n secties spiegelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 haaks zetten</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>%n sectie haaks zetten</numerusform>
            <numerusform>%n secties haaks zetten</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 uitlijnen op een as</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>%n sectie uitlijnen op een as</numerusform>
            <numerusform>%n secties uitlijnen op een as</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 op een andere sectie zetten</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 vrijmaken</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>%n sectie vrijmaken</numerusform>
            <numerusform>%n secties vrijmaken</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 vastmaken</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>%n sectie vastmaken</numerusform>
            <numerusform>%n secties vastmaken</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Wijzigen hoe %1 volgt</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Wijzigen hoe %n sectie volgt</numerusform>
            <numerusform>Wijzigen hoe %n secties volgen</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 vergrendelen</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>%n sectie vergrendelen</numerusform>
            <numerusform>%n secties vergrendelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 ontgrendelen</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>%n sectie ontgrendelen</numerusform>
            <numerusform>%n secties ontgrendelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>%1 op de plaat leggen</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>%1 vastpinnen</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>%n onderdeel vastpinnen</numerusform>
            <numerusform>%n onderdelen vastpinnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>%1 lospinnen</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>%n sectie lospinnen</numerusform>
            <numerusform>%n secties lospinnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Alle onderdelen lospinnen</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Draaiing van %1 wijzigen</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Draaiing van %n sectie wijzigen</numerusform>
            <numerusform>Draaiing van %n secties wijzigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 symmetrisch houden</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>%n sectie symmetrisch houden</numerusform>
            <numerusform>%n secties symmetrisch houden</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Helften van %1 laten verschillen</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Helften van %n sectie laten verschillen</numerusform>
            <numerusform>Helften van %n secties laten verschillen</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 toevoegen</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 verwijderen</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 wijzigen</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 verplaatsen</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 draaien</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 schalen</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>%1 en %2 uitlijnen</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 verbergen</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sjabloon %1 tonen</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n sectie voor %1 voorstellen</numerusform>
            <numerusform>%n secties voor %1 voorstellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Facetten van %1 maken</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 uitvouwen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>%1 instellen</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>%1 hernoemen tot %2</translation>
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
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Voorinstelling %1 bewaren</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Op %1 instellen</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Voorinstelling %1 verwijderen</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Doorgeven om aan te passen</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Ontwerp bewerken</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Waarden instellen</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Bereiken inperken</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>%1 hernoemen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>%n sectie verwijderen</numerusform>
            <numerusform>%n secties verwijderen</numerusform>
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
        <translation>%1 wijzigen</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Volgorde van %1 wijzigen</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>%1 weglaten</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>%n sectie weglaten</numerusform>
            <numerusform>%n secties weglaten</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Weggelaten sectie terughalen</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 knippen</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>%n sectie knippen</numerusform>
            <numerusform>%n secties knippen</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 plakken</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>%n sectie plakken</numerusform>
            <numerusform>%n secties plakken</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Maat behouden</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Maat verwijderen</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Symmetrisch maken</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 inschakelen</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 uitschakelen</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 omzetten</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>%1 losmaken</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Gaten van %1 verwijderen</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Gaten van %n sectie verwijderen</numerusform>
            <numerusform>Gaten van %n secties verwijderen</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Vlakken van %1 verschuiven</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Aantal vlakken van %1 wijzigen</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Tussenruimte van de vlakken van %1 wijzigen</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 is te klein of te dun voor secties van %2 dik.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Er zijn geen secties van %1 gevonden die elkaar vasthouden en staan.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Er is geen sectie van %1 meer gevonden die tussen de bestaande past.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Er is maar %n sectie van %1 gevonden: elke volgende zou in de weg zitten of door niets worden vastgehouden.</numerusform>
            <numerusform>Er zijn maar %n secties van %1 gevonden: elke volgende zou in de weg zitten of door niets worden vastgehouden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Met minder dan %n sectie van %1 is niets gevonden dat staat.</numerusform>
            <numerusform>Met minder dan %n secties van %1 is niets gevonden dat staat.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 is %2 in de grond gezakt, zodat de secties op een platte voet staan.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 is %2 in de grond gezakt en de secties hebben voeten tot %3 hoog, zodat ze staan.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>De afbeelding beweegt; alleen het eerste beeldje wordt getoond.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n tekst is weggelaten.</numerusform>
            <numerusform>%n teksten zijn weggelaten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n afbeelding is weggelaten.</numerusform>
            <numerusform>%n afbeeldingen zijn weggelaten.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Er ontbreekt een getal, een naam of een som.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Een formule heeft hoogstens %1 tekens; deze is langer.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>Bij “%1” heeft de formule meer dan %2 getallen, namen en tekens.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>Bij “%1” staan meer dan %2 haakjes of tekens in elkaar.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1” is hier niet te lezen.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Er ontbreekt iets na “%1”.</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Er ontbreekt iets voor “%1”.</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Tussen “%1” en “%2” ontbreekt een teken, zoals + of *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>Het haakje bij “%1” is niet gesloten.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Na “%1” staat er één sluithaakje te veel.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>De tekst bij “%1” heeft geen sluitend aanhalingsteken.</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>“%1” kan één getal zijn of twee: schrijf een punt, of een spatie na de komma.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>“%1” is een eenheid; daar hoort een getal voor.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>“%1” is op twee manieren te lezen: zet “%2” tussen haakjes.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>“%1” is een tweede vergelijking; met and(…; …) voeg je er twee samen.</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>Er is geen functie met de naam “%1”.</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>“%1” krijgt %2 tussen de haakjes, niet %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>“%1” krijgt minstens %2 tussen de haakjes, niet %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>“%1” krijgt hoogstens %2 tussen de haakjes, niet %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Er is geen waarde met de naam “%1”.</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>“%1” is de dikte van het materiaal; hier is er niet één enkel materiaal.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>“%1” is %2 en kan dus geen eigen eenheid hebben.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>“%1” is %2 en “%3” is %4; alleen wat gelijksoortig is, kun je optellen of vergelijken.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>“%1” is %2; daar valt niet mee te rekenen.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>“%1” is %2; hier is %3 nodig.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>“%1” is %2; de macht kan alleen een klein geheel getal zijn, zoals 2, niet “%3”.</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>“%1” vermenigvuldigt te veel lengten, hoeken of massa’s.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>“%1” is %2, en daar is geen wortel van.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>“%1” is 0, en door 0 kun je niet delen.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>“%1” is negatief en heeft geen wortel.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>De tangens van “%1” is oneindig.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>“%1” ligt niet tussen −1 en 1, dus er hoort geen hoek bij.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>“%1” is geen getal.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>“%1” is niet groter dan 0, en op zulke stappen is niet af te ronden.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>“%1” is te groot.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>“%1” is %2, geen geheel getal; round, floor of ceil maakt er een van.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>“%1” is %2; het moet minstens %3 zijn.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>“%1” is %2; het mag hoogstens %3 zijn.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>“%1” is “%2”, en dat is geen van de keuzes.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>“%1” maakt een tekst van meer dan %2 tekens.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Deze waarde hangt van zichzelf af: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Deze waarde hangt af van “%1”, en die is er op dit moment niet.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Twee waarden heten “%1”.</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>“%1” is geen naam; een naam is een letter, dan letters, cijfers en _, hoogstens %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>“%1” kan geen naam zijn, want het betekent al iets in formules.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Deze waarde is er niet meer.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>De accolade bij “%1” is niet gesloten.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>een gewoon getal</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>een geheel getal</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>een lengte</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>een oppervlakte</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>een inhoud</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>een hoek</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>een massa</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>een tekst</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>een ja of nee</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>geen lengte, hoek, massa of gewoon getal</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Sectie %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Secties %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 en %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>Er is geen materiaal “%1”. Kies er een uit het bestand, of uit de lijst van materialen, zoals Birch plywood, Acrylic of Card.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 laat geen ruimte voor sleuven in het materiaal %2: de speling is %3 mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 past niet bij het materiaal %2, dat %3 mm dik is.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>een %1-bestand</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>een %2-%1-bestand</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 of %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1; of %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>Gebruik: %1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Toont deze hulp.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>Er is geen bestand opgegeven.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Te veel bestanden: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Geeft een benoemde waarde van het model een ander getal, of alles wat een voorinstelling instelt; mag vaker.</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Dikte van elk materiaal.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Snijdt elke sectie uit dit materiaal, of uit dat van een .fff-bestand.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Volledige breedte die de machine wegneemt.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Speling die bij sleuven komt; minder dan 0 om te klemmen.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Zegt van alles wat in het bestand is verbeterd waar het stond.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: gevonden: “%2”, verwacht: %3.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: gevonden: “%2”, verwacht: een getal van %3 tot %4.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: gevonden: “%1”, verwacht: breedte x hoogte in mm, zoals 600x400.</translation>
    </message>
    <message>
        <source>--set: %1</source>
        <translation>--set: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a file&apos;s name, %2 a sentence about what is in it
----------
%1 are names of stocks, %2 is a sentence</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Push all %1 slats together: what their width is less than %2 mm, divided by %1, is the kerf.</source>
        <translation>Duw alle %1 latten tegen elkaar: wat ze samen smaller zijn dan %2 mm, gedeeld door %1, is de snijbreedte.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Bruggetjes die elk onderdeel in zijn plaat houden, en hun breedte in mm, zoals 3:0.4 (geen).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Begint en eindigt elke snede zo ver naast haar lijn, in het afval (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Snijdt randen van twee onderdelen die op elkaar liggen maar één keer; met --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Schrijft een proefstukje in plaats van de onderdelen: sleuven met genummerde breedten, en latten die de snijbreedte laten zien.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: gevonden: “%1”, verwacht: een getal van 0 tot %2, dan een dubbele punt en een breedte van %3 tot %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: gevonden: “%2”, verwacht: een getal van 0 tot %3.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Stap %1: begin met onderdeel %2</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Stap %1: begin een aparte groep met onderdeel %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Stap %1: onderdeel %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Stap %1: onderdelen %2 als één geheel; dit verbindt wat in de stappen %3 en %4 in elkaar is gezet</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Secties: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Verbindingen: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 en %2 komen samen, maar met geen enkele sleuf schuiven ze in elkaar.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Alle secties zijn met elkaar verbonden.</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>een onderdeel van %1</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Niet met de rest verbonden: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Grootte %1 × %2 × %3 mm (breedte, hoogte, diepte)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Massa %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Materiaal %1, %2 mm, platen van %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Onderdeel %1: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, verbindingen %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>Niets te snijden: het model heeft geen secties.</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>Niets te snijden: de sleuven laten van geen enkele sectie iets over.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>-o ontbreekt: geef het bestand om te schrijven.</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: een bestand heeft een naam nodig.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: dit soort bestand kan niet worden geschreven; verwacht: %2.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Zet een mesh, afbeelding of tekening (SVG) naast het model, met deze grootste afmeting in mm; mag vaker.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: gevonden: “%1”, verwacht: een bestand, of een bestand en de grootte ervan in mm, zoals ball.stl@80.</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>Het .fff-bestand om te schrijven; - is de standaarduitvoer.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Schaalt de mesh tot deze grootste afmeting; zonder dit zo groot als het bestand zegt, anders 254.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: gevonden: “%2”, verwacht: een geheel getal van %3 tot %4.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: dit stuk is te groot voor de strook.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Lengte: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Dichtheid: %1 %</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Onderdelen: %1, platen: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm, %3: %4 onderdelen, %5 % bedekt</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: een onderdeel is te groot voor zijn plaat.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: gevonden: “%1”, verwacht: groups of files.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: er is geen machine “%1”; verwacht: %2, of een .json-bestand.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files heeft een naam nodig: de standaarduitvoer is maar één bestand.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>Sleuven zijn %1 mm breed getekend.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>Sleuven zijn %1 mm breed getekend (%2 − %3 snijbreedte).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Er staan nog platen van een eerdere export: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Lapjes: %1, driehoeken: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Plekken die open blijven: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: %2 m snijden, ongeveer %3 min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>Platen zijn groter dan het snijbed van %1 x %2 mm; kies andere met --sheet.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Onderdelen: %1, platen: %2, %3 % gebruikt.</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>Het bestand om te schrijven; - is de standaarduitvoer.</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1; nodig als de bestandsnaam het niet zegt.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Laat de balk van 100 mm naast de platen weg.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Van de rand van de plaat tot de dichtstbijzijnde snede (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Tussen naburige sneden (2).</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Alleen kwartslagen, voor platen met een vezelrichting.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Legt onderdelen naar hun ware omtrek en zoekt zo veel seconden; 0 neemt de eerste indeling (naar hun rechthoeken).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: één SVG met een groep per plaat; files: OUT-1.svg, OUT-2.svg enzovoort (groups).</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>De machine die snijdt, voor de kleuren, snelheden en G-code: %1; of een .json-bestand met een eigen machine (generic).</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Schrijft de vorm die de secties suggereren als een oppervlak (%1), in plaats van de lichamen.</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Met -o - ontbreekt het formaat: --format %1.</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: dit soort bestand kan die niet bevatten; verwacht: %1.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: dit soort bestand kan het niet bevatten; verwacht: %1.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Pixels van de afbeelding (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 tot iso4, front, right, top, left, back, bottom, of fit: weer de voorkant (iso1).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: gevonden: “%1”, verwacht: breedte x hoogte in pixels tot %2, zoals 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: gevonden: “%1”, verwacht: een van %2.</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Staat.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Valt om.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Valt om: het heeft maar één lijn om op te staan.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Een deel ervan heeft niets om op te staan.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>Het staat niet op de grond.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Glijdt weg over de grond.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>De delen ervan bewegen tegen elkaar.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Houdt het.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Houdt het maar net: het kan in een hoek scheuren.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Breekt.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Een verbinding wordt uit elkaar getrokken.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>Sterkte wordt alleen berekend voor wat stilstaat.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Niet beoordeeld: de sterkte van een materiaal is niet bekend.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Of het houdt, was niet te berekenen.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Zou staan %1.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Te zwak: het houdt, maar niet met de gevraagde veiligheid.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Zou het houden %1.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 drukt met %2 N op de grond.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>Verbinding %1–%2 wordt met %3 N uit elkaar getrokken: lijm die, of draai de sleuven om.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>Hoe %1 buigt, was niet te berekenen; het telt als star.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>Hoe secties buigen, was niet te berekenen; ze tellen als star.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Verbindingen kunnen de belasting op meer dan één manier delen (onbepaald, %1); de slechtste manier telt.</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>De spanning in %1 was niet te berekenen.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 is niet beoordeeld: de sterkte van het materiaal is niet bekend.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Een duw van %1 N mist het materiaal van %2; de dichtstbijzijnde plek vangt hem op.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Een gewicht van %1 mist het materiaal van %2; de dichtstbijzijnde plek vangt het op.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 in totaal</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1 N in totaal</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 keer de belasting</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>Zwakst in %1: %2 van de sterkte van het materiaal op de smalste plek, %3 in de hoek.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Buigt %1 mm door, het meest %2.</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Kan scheuren vanaf %1.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Breekt bij %1.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Weegt %1 N met alles erop.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>gevonden: “%1”, verwacht: NAAM=WAARDE, zoals width=400.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>gevonden: “%1”, verwacht: NAAM=WAARDE, zoals width=400, of een voorinstelling: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>“%1” kan %2 of %3 zijn; schrijf een van deze.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>het model heeft geen waarden met namen.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>er is geen waarde “%1”; verwacht: %2.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Geen waarde die anderen kunnen aanpassen, heeft een bereik en wordt gebruikt.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Geprobeerd: %1 van %2 hoeken van de bereiken, %3 varianten ertussen.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Alle zijn goed.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 van %2 voldoen niet:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Waar:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Vlakken: %1, schillen: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>Het vlak snijdt het niet.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Gat: %1 mm², %2 punten</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Lus: %1 mm², %2 punten</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Oppervlakte: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Een punt van het vlak en zijn normaal, zes getallen met komma’s.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Schaalt de mesh eerst tot deze grootste afmeting en zet die op de grond.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Geeft JSON, voor andere programma’s.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>--plane ontbreekt.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: gevonden: “%1”, verwacht: zes getallen, waarvan de laatste drie een richting zijn.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Geen vingers waar platen onder minder dan 30° of meer dan 150° samenkomen: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Geen vingers waar de ene plaat voorbij de andere gaat of er niet bij komt: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Geen vingers aan randen die te kort zijn voor drie ervan: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Een plaat van %1 mm is niet te vouwen, verwacht: hoogstens %2 mm; met --stock kies je een andere.</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: het heeft %2 vlakke stukken, verwacht: hoogstens %3; met --faces worden het er minder.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: geen vlak stuk ervan is groot genoeg voor een sectie; met --size wordt het groter.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Uitslagen: %1, vouwen: %2, naden: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Vereenvoudigt de mesh eerst tot zo veel driehoeken; wat samen vlak is, is één stuk.</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Uitslagen om langs geritste lijnen te vouwen, van plaat tot 3 mm, in plaats van losse vlakke platen.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Met --unfold: breedte van de plakranden; 8 mm voor plaat tot 1,5 mm, anders 0 mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap hoort bij --unfold.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Stukken te klein voor een sectie: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Secties: %1, verbindingen: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Hoelang er wordt gezocht (10); 0 neemt de eerste indeling.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Een ander getal geeft een andere indeling, hetzelfde getal dezelfde.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Hoe onderdelen mogen worden gedraaid: none (niet), 180, 90 of free (vrij).</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Van de rand van de plaat tot de dichtstbijzijnde snede.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Tussen naburige sneden.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: gevonden: “%1”, verwacht: none, 180, 90 of free.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>Het model heeft geen operaties.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 sectie</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Geeft JSON, voor andere programma’s; stappen worden vanaf 0 geteld.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Grootste afstand tussen koorden en krommen (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: dit soort bestand kan niet worden geschreven; verwacht: .png.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: gevonden: “%1”, verwacht: labels, checks, stress, forces, skin, of meer daarvan met komma’s ertussen.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: er worden geen krachten getoond; het staat niet, of ze waren niet te berekenen. “check” zegt waarom.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>Het PNG-bestand om te schrijven; - is de standaarduitvoer.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: de namen van de secties; checks: omlijnt secties met een probleem; stress: de zwakste doorsneden; forces: wat voeten en verbindingen dragen; skin: de vorm die de secties suggereren.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Spanning met eindige elementen, in kleur over de hele secties; duurt seconden.</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Een afbeelding heeft een scherm met OpenGL 3.3 nodig; dat is er niet.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>De afbeelding kon niet als PNG-bestand worden geschreven.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>Het model om mee te beginnen; zonder dit een nieuw model.</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: gevonden: “%1”, verwacht: X, Y, Z, XY, XZ, YZ of radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>--count en --spacing zijn allebei opgegeven; verwacht: één van de twee.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: vlakken rond een as hebben geen afstand; verwacht: --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>De assen waar vlakken dwars op staan: X, Y, Z, twee ervan voor een raster, of radial: rond de verticale as (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Vlakken in elke richting (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>Van vlak tot vlak.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: geen vlak snijdt er een sectie uit die groot genoeg is.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size is voor .png; een PDF is zo groot als zijn papier.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper is voor .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: gevonden: “%1”, verwacht: a4 of letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Stap %1 van %2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 of letter (standaard wat in jouw land gebruikelijk is).</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Hoeveel secties (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Een ander getal geeft andere secties (1).</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Voorinstellingen: %1. Ingesteld is %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Voorinstellingen: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>Het model heeft geen waarden met namen.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Probeert de bereiken van de waarden die anderen kunnen aanpassen.</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Een ander getal probeert andere plekken, hetzelfde getal dezelfde.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>er zijn meer cellen dan namen.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Een CSV-bestand: namen van waarden, en een regel getallen voor elke variant.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>De map om naar te schrijven; die wordt gemaakt als die er niet is.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>Wat er van elk wordt geschreven (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>--table en -o zijn allebei nodig.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: gevonden: “%1”, verwacht: een soort snijbestand.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: geen regel getallen gevonden, verwacht: één onder de namen.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: een aanhalingsteken is niet gesloten.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: de map kan niet worden gemaakt.</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Zet een gewicht op een sectie, in het midden of bij X,Y in mm: “Rib 4=350g”, “Rib 4@10,25=0.35kg”. Mag vaker.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: verwacht: NAAM=MASSA, zoals in “Rib 4=350g”.</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: verwacht: een massa boven 0 en tot 1000000 kg achter de =, met g, kg, oz of lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: er is geen sectie “%2”.</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: sleuven laten niets over van “%2”.</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: twee kolommen heten &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: dit soort bestand kan niet worden geschreven; verwacht: .pdf, .html of .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size is voor .png; een webpagina past zich aan het scherm aan.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>Een afbeelding van de stappen kon niet worden gemaakt.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Een PDF-bestand met alle stappen (- is de standaarduitvoer), OUT.html voor een webpagina waarop het model gedraaid kan worden, ook op een telefoon, of OUT.png voor OUT-01.png, OUT-02.png enzovoort.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: zoveel reststukken van het materiaal %1 zijn te veel.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Platen van %1 die ontbreken: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>De stappen zitten niet bij de bestanden: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Platen van %1 hebben geen ruimte binnen marges van %2 mm.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: &quot;%1&quot; gevonden, verwacht breedte x hoogte in mm, zoals 300x200, of een .svg-bestand, met daarachter hoeveel er zijn, zoals :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Maat van een plaat, zoals 600x400; met :N erachter hoeveel er zijn.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: het model heeft geen materiaal &quot;%2&quot;; het wordt gesneden uit %3.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: het model wordt gesneden uit %2. Zeg van welk materiaal dit is, zoals in &quot;%3=%1&quot;.</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Een plaat van een andere maat, of wat van een plaat over is als de grootste omtrek uit een .svg-bestand op ware grootte, die vóór hele platen wordt opgemaakt; met :N erachter zoveel ervan. Bij een model van meerdere materialen met de naam van het materiaal ervoor: &quot;Birch plywood=300x200&quot;. Mag worden herhaald.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Laat alleen wanden van deze breedte over, langs de contouren en waar andere kruisen.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Graveert de nummers van elke verbinding in een eigen kleur, op beide onderdelen dezelfde.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: dit soort bestand kan ze niet bevatten; verwacht %1.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Eén keer gesneden voor twee onderdelen: %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>Er liggen geen randen van twee onderdelen op elkaar: niets wordt maar één keer gesneden. Met --spacing 0 kunnen rechte randen dat.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>De sleuven %1 tot %2 hebben een speling van %3 tot %4 mm: duw de strook erin en geef het materiaal de speling van de sleuf die past.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>Geen ruimte voor de aan- en uitloop van alle sneden: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>Over FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licenties</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Voor foutmeldingen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Teken vlakke onderdelen in 3D, zie meteen hoe ze passen, en snijd ze. Het werkt zonder account, en niets verlaat deze computer.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Naar “FlatFitFab: Interactive Modeling with Planar Sections” van J. McCrae, N. Umetani en K. Singh (UIST 2014). Vrije software onder de GNU General Public License, versie 3 of later.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiëren</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Waarmee dit programma is gebouwd</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Tekst van de licentie</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Dit programma</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Vensters, bestanden en tekst</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Exacte meetkunde</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Vectoren en matrices</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Omtrekken snijden en verschuiven</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Tekeningen lezen</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Tekeningen uitpakken</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modellen met afbeeldingen en meshes</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Delen die CGAL gebruikt</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Getallen zonder afronding</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Getallen met veel cijfers</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Resultaten die fouten kunnen zijn</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>Het model in webpagina’s van de stappen</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Bewerken</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Beeld</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Sectie</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>Operatie</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>Controles</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Aanzicht</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Panelen</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Op een vlak tekenen</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Erop tekenen</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Schikken</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Selecteren</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Werkbalk voor aanpassen</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>zojuist</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minuut geleden</numerusform>
            <numerusform>%n minuten geleden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n uur geleden</numerusform>
            <numerusform>%n uur geleden</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gisteren</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n dag geleden</numerusform>
            <numerusform>%n dagen geleden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Ouder dan de tekening</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: ouder dan de tekening</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Oordelen</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>Draagt</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>Zonder buigen</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>De sectie is er niet</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>Zoals het nu is, staat het niet</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>Zoals het nu is, breekt het</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Sterkte onbekend</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>bezig… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>bezig…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestopt</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>niet te berekenen</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Getallen van het tekengereedschap</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Afstand</translation>
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
        <translation>Lengte</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
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
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Eruit</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopieën</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Ouder dan de tekening</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckWords</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Tips only past 12°.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Goed</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Onbekend</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Opmerking</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Waarschuwing</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Probleem</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1 op %n plek</numerusform>
            <numerusform>%1 op %n plekken</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 van %2: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Controles</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>De controles beginnen bij de eerste sectie.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Controleren…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Ouder dan de tekening</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Er is nog geen sectie om te controleren.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Geen problemen.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Nog bezig; tot nu toe geen problemen.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Probleem %1 van %2: %3.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Er wordt nog gecontroleerd. Dit gebeurt zodra het resultaat bekend is.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>Het model is gewijzigd; dit kan niet meer.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Gedaan: %1.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Als je klikt: %1.</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>Probleem %1 van %2, plek %3 van %4: %5.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>Exporteren naar</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Opdracht zoeken</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Typ wat je wilt doen</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Passende opdrachten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Geen passende opdrachten</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Probeer een ander woord</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Pasproef schrijven</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 pasproef</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Pasproef geschreven naar %1. Snijd die uit en duw de strook in de sleuven; bij Exporteren geef je op welke paste.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: geen speling</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: %2 smaller</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: %2 breder</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Bruggetjes</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>Zo veel korte onderbrekingen in de snede van elk onderdeel houden het in zijn plaat; 0: geen</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Breedte van bruggetjes</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Aanloop van sneden</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Elke snede begint en eindigt zo ver naast haar lijn, in het afval; 0: op de lijn</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>één keer snijden</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Gedeelde randen</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>Van onderdelen die tegen elkaar liggen, waar de tussenruimte 0 is</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Welke van de genummerde sleuven van een pasproef de plaat het best vasthoudt (te snijden: menu Bestand, of bij de bestanden voor de werkplaats). Stelt de speling in.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Passende sleuf</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>ongeveer %n min</numerusform>
            <numerusform>ongeveer %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>Maten</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Maat %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>Een andere lengte schaalt het hele model</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Een andere lengte rekt %1 tussen de twee plekken uit</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Deze maat verwijderen</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Een model openen</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Een model invoegen</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Een tekening importeren</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Sjabloon toevoegen</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>Niets ingevoegd: %1 heeft geen secties.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Het model opslaan</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Niet-opgeslagen wijzigingen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>De wijzigingen in %1 opslaan?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Zonder opslaan gaan ze verloren.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Niet opslaan</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Terug naar opgeslagen versie</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 is weer zoals het was opgeslagen. Met Ongedaan maken komen je wijzigingen terug.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 openen…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Een ander bestand kiezen</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Uit de lijst verwijderen</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 opslaan…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Ergens anders opslaan…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Opgeslagen in %1.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Gewijzigd op schijf</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 is door een ander programma gewijzigd.</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>Bij overschrijven gaan die wijzigingen verloren.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Opslaan als…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Overschrijven</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>naamloos</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Tekenen</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Lokale symmetrie</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Een contour in de sleuf spiegelen als die maar aan één kant ervan is getekend. Shift doet tijdens het tekenen het omgekeerde.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Eerste spiegelen</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Ook de eerste sectie spiegelen, in de verticaal door haar begin</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>Afsnijden bij grond</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Bij de grond recht afsnijden: wat eronder is getekend, weglaten</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Vastklikken</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>Vastklikken op punten, uitlijnlijnen, grond en raster</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Beeld draait over</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>Bij 90° kijk je recht op het nieuwe vlak; bij minder blijft de sectie waarop je begon zichtbaar</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Draaitijd</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Hoelang het beeld erover doet om naar het vlak van een nieuwe sectie te draaien</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingPage</name>
    <message>
        <source>A hole, while you draw it</source>
        <translation>Een gat, terwijl je tekent</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Een nieuwe contour, terwijl je tekent</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>Nieuwe sectie, terwijl je tekent</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>Nu nog de contour</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Sleuf</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>Eigen sleuf</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Segmenten</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>lippen</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>gesloten</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>opent omhoog, %1 diep</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>opent omlaag, %1 diep</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>opent opzij, %1 diep</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Niet gespiegeld.&lt;/b&gt; De twee helften zouden elkaar bij de sleuf niet raken.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Niet gespiegeld.&lt;/b&gt; Je tekende aan één kant van de as: %1 aan de ene kant, %2 aan de andere. Symmetrie staat uit, of Shift is ingedrukt.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;Gespiegeld.&lt;/b&gt; Je tekende aan één kant van de as: %1 aan de ene kant, %2 aan de andere. Ga er %3 of meer overheen om beide kanten zelf te tekenen.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Nieuwe sectie</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Sjabloon</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Volgt</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Op de hulplijn</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1 % van de haal</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Verst ernaast</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Er kan maar één getal tegelijk een waarde volgen.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Dit getal kan geen waarde volgen.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Geen. Klik op een sectie om die weg te laten of los te maken.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Weer tonen</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, weggelaten</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1, losgemaakt</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>Snijbestanden exporteren</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Daarna de map openen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Huid over %1</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 als lichamen</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 op %2 · %3 snijden</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Bezig…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Toch exporteren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Indelen…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Wijzigen…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 enzovoort, in %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Vervangt %1 in %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>de persoonlijke map</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Plaat %1 van %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Onderdelenlijst</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Vorige plaat (Page Up)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Volgende plaat (Page Down)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>De hele plaat tonen</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Een huid heeft geen platen: het bestand bevat de vorm die de secties suggereren, als een oppervlak over hun contouren.</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>Lichamen hebben geen platen: het bestand bevat het model zoals het staat, op ware grootte, met sleuven.</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Plaat %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Er valt niets te snijden.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Bezig…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Gebruikt: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Onderdelen worden op platen gelegd…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>Welk materiaal?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Opnieuw meten</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Gemeten dikte</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Meet de plaat die je gaat snijden met een schuifmaat: de sleuven worden erop getekend.</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>Welke plaat?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Breedte van de plaat</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Hoogte van de plaat</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, %2 dik</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Eigen maat</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>Welke machine?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Kleuren, lagen, snelheden en G-code zoals deze machine en haar programma ze nemen, en wat ze van elk materiaal weghaalt</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, gemeten %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>Dat heb ik gemeten</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>%n reststuk wordt eerst opgebruikt.</numerusform>
            <numerusform>%n reststukken worden eerst opgebruikt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Willekeurige laser</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Geen enkel onderdeel ligt op een reststuk.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>%1 van %n reststuk wordt eerst opgebruikt.</numerusform>
            <numerusform>%1 van %n reststukken eerst opgebruikt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2 keer</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>Niet te snijden</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Controleren…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Niets om op te letten.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Een plaat van %1 heeft geen ruimte binnen marges van %2.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>De snijbreedte van %1 is 0: sleuven worden breder en onderdelen kleiner, met wat de machine wegneemt.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>De platen zijn groter dan het bed van %1 met %2. Kies kleinere.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Passing</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Snijbreedte (heel)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Speling sleuf</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Getekende sleuf</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Indeling</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Tussenruimte</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Randmarge</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Kwartslagen voor een plaat met vezelrichting</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm, onder de platen</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Meetbalk</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Naast de platen getekend, niet gesneden: meet hem op je machine na om de maat te controleren</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Sneden</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Elke hoek</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Kwartslagen</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Halve slagen</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Zoals getekend</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Wordt bewaard voor dit materiaal en de gekozen machine</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>een kleur per verbinding</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Verbindingsnummers</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>De twee onderdelen van een verbinding hebben het nummer in dezelfde kleur: voor papier, en voor machines waaraan je per kleur zegt wat ze moeten doen</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>Twijfel? Snijd eerst een pasproef…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>De sleuven laten niets van %1 over. Het wordt niet gesneden.</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 is groter dan de plaat en ligt op een plaat van eigen maat.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 is te smal voor een nummer.</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 heeft een gat of inkeping die smaller is dan de snijbreedte en niet wordt gesneden.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 heeft geen ruimte voor de nummers van alle verbindingen.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n onderdeel</numerusform>
            <numerusform>%n onderdelen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n plaat</numerusform>
            <numerusform>%n platen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 exporteren…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 tot %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>%1 op %2 geëxporteerd naar %3.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>%1 op %2 geëxporteerd naar %3; sleuven zijn %4 breed getekend.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>%1 op %2 geëxporteerd naar %3; sleuven zijn %4 breed getekend (%5 − %6 snijbreedte).</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>%1 als lichamen geëxporteerd naar %2.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Huid geëxporteerd naar %1; %n plek blijft open.</numerusform>
            <numerusform>Huid geëxporteerd naar %1; %n plekken blijven open.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Huid geëxporteerd naar %1.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materialen…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Ergens anders exporteren…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Er staan nog platen van een eerdere export: %1.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>Niet geëxporteerd: de bestanden die er zijn, blijven.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>Er is %n plaat van %1 meer nodig dan er zijn.</numerusform>
            <numerusform>Er zijn %n platen van %1 meer nodig dan er zijn.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Er ontbreekt een getal.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1” is hier niet te lezen.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Er ontbreekt iets na “%1”.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Een haakje is niet gesloten.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>Er staat één sluithaakje te veel.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>Door 0 kun je niet delen.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Er is geen waarde met de naam “%1”.</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>Dit is geen lengte; vermenigvuldig een lengte met een gewoon getal.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>Dit is geen massa; vermenigvuldig een massa met een gewoon getal.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>“t” is de dikte van het materiaal; hier is er niet één enkel materiaal.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>regel %1</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>Er is niets geopend: er was geen bestand genoemd.</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 is geen model. FlatFitFab opent %2.</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>%1 kon niet worden geopend: het staat niet meer in %2. Er is niets gewijzigd.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>%1 kon niet worden geopend: %2. Er is niets gewijzigd.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>%1 kon niet worden geopend: %2 (%3). Er is niets gewijzigd.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>Het bestand op schijf is nog het oude.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Er is niets geschreven.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>de map %1 bestaat niet</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>Niet geëxporteerd: %1. %2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>%1 kon niet worden opgeslagen: %2. %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>Vorm</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>Wordt zo door een van de punten te verplaatsen</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Het midden, in de coördinaten van de sectie</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedraaid</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Gat %1</translation>
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
        <source>Free form</source>
        <translation>Vrije vorm</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>Snijbestand</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Papier of afbeelding</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Lichamen om te printen of te renderen</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Lijst van onderdelen</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Alles voor een werkplaats</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>Welk bestand?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Waarvoor is het?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Een bestand per plaat</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Overtrekken</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Ligt op</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Grond</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Op de grond leggen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Voor</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Rechtop zetten, van voren te zien</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Zijkant</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Rechtop zetten, van rechts te zien</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sectie</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Op de geselecteerde sectie leggen en ermee laten meegaan</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Omkeren</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Zoals van achteren gezien</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Twee uitlijnen</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>De laatste twee afbeeldingen als voor- en zijaanzicht van hetzelfde: even hoog, en boven dezelfde plek</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Drempel</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>Hoe donker het moet zijn om te worden overgetrokken</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Afronding</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>Hoe rond hoeken worden</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Omtrekken</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Secties maken</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Secties van de omtrekken, op het eigen vlak</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Gaten snijden</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Gaten in de sectie waarop het ligt, of die is geselecteerd</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Graveren</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Lijnen op de sectie waarop het ligt, of die is geselecteerd</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: te veel voor secties</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>uit elkaar getrokken, %1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n verbinding uit elkaar getrokken, tot %1&#x202f;N</numerusform>
            <numerusform>%n verbindingen uit elkaar getrokken, tot %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modellen (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Tekeningen (%1)</translation>
    </message>
</context>
<context>
    <name>fff::ui::GizmoMarks</name>
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
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Eruit</translation>
    </message>
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
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>Toetsen</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pagina’s</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>De toetsen als pagina opslaan</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-documenten (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>FlatFitFab-toetsen</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 kon niet worden geschreven.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Geschiedenis</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Elke stap; kies er een om ernaar terug te gaan.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Hier komt elke stap te staan; je kunt naar elke stap terug.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>Terug bij het begin. Klik op een latere stap om die weer uit te voeren.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>Het model is weer zoals na “%1”.</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Zoals geopend</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Nieuw model</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Hier opgeslagen</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Delete verwijdert een sectie; slepen, of Alt met een pijltjestoets, verandert de volgorde.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (verwijderd)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Kiezen…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is what an operation works on (&quot;Along&quot;), %2 the name of a section</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::InstanceGroup</name>
    <message>
        <source>Made by an operation</source>
        <translation>Gemaakt door een operatie</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Gemaakt door</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Beeld van</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>Deze weglaten</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Losmaken</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>Hiervan een getekende sectie maken; de operatie maakt de andere nog wel</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Gemaakt van</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>Wijzigingen aan één ervan gelden voor alle</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>Teken deze opnieuw; alles wat ervan is gemaakt, volgt</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Verbinding</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Sleuven</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Automatische instellingen herstellen</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secties</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Soort</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>Opent</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Sleuven omdraaien</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Sleuf</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
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
        <translation>Trefpunt</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>lip, %1 breed</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>gesloten, %1 lang, %2 breed</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>%1 diep, %2 breed</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 en %2 overlappen elkaar.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 inkorten</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Trefpunt %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>De sleuf van %1 krijgt dit deel van de diepte, die van %2 de rest</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Met de hand ingesteld; automatisch is 50&#x202f;%. %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Secties: %1 en %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Met de hand ingesteld; de automatische instelling is te herstellen</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 opent</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>De kant waarheen de sleuf van %1 opent; die van %2 opent naar de andere</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>In %1</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Het programma weer de soort, de richting en de trefpunten laten kiezen</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>Aan deze verbinding is niets met de hand ingesteld</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>De verbinding met %1 selecteren</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Nog geen</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>kruisverbinding</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>verlengde kruisverbinding</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>pengat</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>lippen</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>geen verbinding</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>Kruisverbinding</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>Lange kruisverbinding</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Pengat</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Lippen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>Door de speling van het materiaal blijft er geen sleufbreedte over</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>Sleuven kunnen niet naar buiten openen: er zit een gat in de weg</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>Op de ene plek kunnen ze maar de ene kant op schuiven, op de andere alleen de andere kant op</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Niets zou ze vasthouden: waar sleuven zouden beginnen, zitten gaten</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>De ene sectie steekt voorbij de andere, hoe ze ook schuiven</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Geen van beide secties steekt voorbij de andere</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Ze komen op meer dan één plek samen</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Geen van beide secties past door een gesloten sleuf in de andere</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>De ene sectie eindigt alleen op de andere</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Geen van beide secties eindigt op het vlak van de andere</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>Er is geen ruimte voor lippen en hun sleuven</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Ze komen onder minder dan 30° samen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Naar rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Naar links</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Omlaag</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Naar voren</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Naar achteren</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Druk op de toetsen</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>Toetsen</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>Opslaan als pagina om af te drukken…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>In het beeld</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>De eerste sectie tekenen</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>slepen in het midden</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Een sectie dwars op een andere tekenen</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>eruit slepen, doorgaan</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Het beeld draaien</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>naast het model slepen</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Dichterbij komen</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>wiel</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Het beeld verschuiven</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>slepen met de middelste knop</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selecteren</translation>
    </message>
    <message>
        <source>click</source>
        <translation>klikken</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Een groep selecteren</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>Shift en slepen</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Zien wat ermee kan</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>rechts klikken</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Een punt toevoegen</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>dubbelklikken op de contour</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Tekenen zonder vastklikken</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>Ctrl ingedrukt houden</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Indeling</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Tussenruimte</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Randmarge</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Onderdelen in gaten</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>Kleine onderdelen mogen in de gaten van grote liggen</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Inch</translation>
    </message>
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
</context>
<context>
    <name>fff::ui::LibraryDock</name>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliotheek</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Selectie toevoegen</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>De selectie in de bibliotheek zetten; zonder selectie het hele model</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Map…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>De map kiezen waarvan de modellen hier staan</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>Onderdelen die je bewaart, verschijnen hier: selecteer een paar secties en klik op Selectie toevoegen.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Map van de bibliotheek</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>Niets toegevoegd: er is nog niets getekend.</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>De map van de bibliotheek, %1, kan niet worden gemaakt.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 staat nu in de bibliotheek.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 ligt in de prullenbak.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>%1 kon niet naar de prullenbak.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Aan het model toevoegen</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>Naar de prullenbak</translation>
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
        <translation>Duw</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Waar het werkt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Voorwerp</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Gewoon gewicht</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>Ook in kg, oz of lb: 1,5 kg, 2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Water erin</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Zwaartepunt</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>Hoogte boven de plek: hoe hoger, hoe eerder het model kantelt</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kracht</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N is ongeveer wat 1 kg weegt</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Richting X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Richting Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Richting Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>In het eigen vlak van de sectie, vanaf haar oorsprong</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Plaats X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Plaats Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Spreiding</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>Op een punt</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>Over een vlakje</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Langs de rand</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Hangend</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>Ook op kopieën</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Kopieën die operaties van de sectie maken, dragen er elk een</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Gewichten en duwen</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 hernoemt, Del verwijdert.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichten</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Duwen</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Duw</translation>
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
        <translation>Sjabloon</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Aangetrokken</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Het sjabloon naar het vlak van deze sectie buigen, zodat hulplijnen van andere secties volgen wat is getekend</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>Binnen</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Werkbalk</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Herhalen</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Secties herhalen en in elkaar laten overgaan</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>Het model kan niet worden getoond: het grafische stuurprogramma biedt geen OpenGL 3.3. Een nieuwer stuurprogramma kan helpen.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>Het model kan op dit scherm niet worden getoond.</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Begin een nieuw model, ga verder met een bestaand of bekijk een voorbeeld.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Hersteld: %n model dat niet was opgeslagen</numerusform>
            <numerusform>Hersteld: %n modellen die niet waren opgeslagen</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Hersteld: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Map tonen</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Dit model is er om aan te passen. Met “Ontwerp bewerken” komt alles terug.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Help: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Secties voorstellen</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Hoeveel</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Voorstellen</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Zoekt secties die de vorm weergeven, elkaar vasthouden en staan</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Nog een</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Een sectie die tussen de bestaande past</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Een andere</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>Andere secties in plaats van de laatste</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Vlakken</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Facetten maken</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>Bouwt het van vlakke platen met vingers langs de randen. De mesh wordt eerst tot zo veel vlakken vereenvoudigd; wat samen vlak ligt, is één plaat.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Uitvouwen</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>Legt het plat, om in één of enkele stukken uit karton te snijden en langs geritste lijnen te vouwen. Randen die aan elkaar moeten, hebben hetzelfde nummer.</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>Markeringen</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedraaid</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Markering %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Gegraveerd</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Geritst</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Deze markering verwijderen</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Letterhoogte</translation>
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
        <source>Reading %1…</source>
        <translation>%1 lezen…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 is te groot voor een model en is daarom %2 groot gemaakt. De grootte staat onder Sjablonen.</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 kent geen eenheid en is daarom %2 groot gemaakt. De grootte staat onder Sjablonen.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Meshes, afbeeldingen en tekeningen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Geplakte afbeelding</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>Op de schaal van %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Dit bericht sluiten</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>En nog %n.</numerusform>
            <numerusform>En nog %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Eenheden</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>nog niets getekend</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Nieuwe secties</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Materiaal van de secties die je hierna tekent</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Materiaal bewerken</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>Beweging</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>Toont overdreven waar het model buigt of loslaat. Er wordt niets gewijzigd.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Afspelen</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>Beweging is beperkt: gebruik de schuifregelaar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>Hoe het beweegt, is niet bekend.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>Zet “Secties buigen” aan om te zien hoe het buigt.</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Getoond zoals het uit elkaar begint te gaan.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Buigt %1 door, %2 keer zo ver getoond.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Buigt %1 door.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>Benoemde waarden</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Een naam is een woord van letters en cijfers, anders dan “t” en de eenheden.</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Deze waarde verwijderen</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Sectie %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>gemengd</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>Minstens %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>Hoogstens %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Reststuk</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Een plaat van een andere maat, die vóór hele platen wordt opgebruikt</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>Uit een tekening…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>Wat er van een plaat over is, als de grootste omtrek van een SVG-bestand op ware grootte, met zijn gaten</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Breedte van het reststuk</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Hoogte van het reststuk</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Hoeveel van dit reststuk</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Dit reststuk weghalen</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, uit een tekening</translation>
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
        <translation>Een andere kiezen</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Meer toestaan</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Zo laten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Kiezen</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Uitzonderingen</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Omzetten</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Wat de operatie maakt, omzetten in getekende secties; de operatie zelf is dan weg</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>De operatie verwijderen, met alles wat ze maakt</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Invoer</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Kiezen</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Meer toestaan</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Operaties, op volgorde</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 hernoemt, spatie verbergt en toont, Alt met een pijltjestoets verandert de volgorde.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Verborgen: tonen</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Verbergen</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Overzicht</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Filter op naam of materiaal</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secties</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 hernoemt, spatie verbergt en toont.</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>Secties verschijnen hier zodra je ze tekent.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, wordt getekend</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Vergrendeld: ontgrendelen</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>Vergrendelen</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Verborgen: tonen</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Verbergen</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Teken hier een vorm met de linkerknop ingedrukt.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, en hier nog %n</numerusform>
            <numerusform>%1, en hier nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Sleuven berekenen…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 vanaf het laatste punt</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>Gespiegeld in de sleuf</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>Gespiegeld in de verticaal</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Bij de grond recht afgesneden</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Grond %1 onder deze rand</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Sleuf %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Sleuf %1, %2</translation>
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
        <translation>Zoals het uit de secties volgt</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Met de hand ingesteld</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Onderdelenlijst</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Aantal</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>Fysica</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Weergave</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Spanningslijnen</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Tonen vanaf</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Deel van de sterkte van de plaat; minder wordt niet getoond</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>eindige elementen</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Secties buigen</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Waar verbindingen een belasting delen, bepaalt de stijfheid van de secties hoeveel elk draagt. Duurt even.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Sterktekaart</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Kleurt de geselecteerde sectie naar de massa die elke plek ervan kan dragen, naast wat al op het model staat. Duurt even.</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Zwakste plekken</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Belastingen</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Zet een gewicht op het model om te zien wat het kan dragen.</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Eigen gewicht</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Op de grond</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Gewicht toevoegen</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Duw toevoegen</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Hoe streng</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Veiligheidsfactor</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>Hoeveel keer zijn belasting het model moet kunnen dragen om als sterk genoeg te gelden</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Kerffactor, hoogstens</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>Hoeveel de spanning in binnenhoeken oploopt, volgt uit de lengte van de smalste plek, tot deze factor; sleuven met ronde uiteinden hebben minder nodig</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>maandenlang</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>Belasting blijft</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Een materiaal draagt dan minder, zoals ervoor ingesteld: acrylaat maar een kwart</translation>
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
        <translation>Deze duw verwijderen</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Dit gewicht verwijderen</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>bezig… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>bezig…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestopt</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>niet te berekenen</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>de geselecteerde sectie</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>selecteer een sectie</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Teken een sectie om te zien wat die kan dragen.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Of het houdt, was niet te berekenen.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Ouder dan de tekening, bezig…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Het staat niet; er wordt geen spanning getoond.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Een verbinding wordt uit elkaar getrokken; er wordt geen spanning getoond.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Sterkte onbekend: een materiaal is niet beoordeeld. Vul de sterkte in onder Materialen.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>Actueel. Verbindingen kunnen de belasting op vele manieren delen; de slechtste telt.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>Actueel. Alle krachten zijn in evenwicht.</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Buigt %2 door.</translation>
    </message>
    <message>
        <source>%1, %2: %3&#x202f;%</source>
        <extracomment>the name of a section, a place in it such as &quot;at its neck&quot;, a number of percent</extracomment>
        <translation>%1, %2: %3&#x202f;%</translation>
    </message>
</context>
<context>
    <name>fff::ui::PlaceGroup</name>
    <message>
        <source>across its slit</source>
        <translation>in de sleuf</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>in de verticaal</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>in de horizontaal</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Plaats</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Vrij</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>Ze beweegt niet mee met de sectie waarop ze zit en houdt haar hoek er niet mee</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Vergrendeld</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Ze blijft zoals ze is, tenzij de sectie waarop ze zit beweegt</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>Wijzigingen aan punten van de ene helft gelden ook voor de andere</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Op</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niets</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Klik op een andere sectie om er deze op te zetten</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>Niet op een andere sectie</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Hoek daarmee</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Volgt</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>naar verhouding</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>het linkereinde</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>het rechtereinde</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>het ondereinde</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>het boveneinde</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Hoe haar plaats volgt als een waarde de sectie waarop ze zit uitrekt: zo ver als die daar wordt uitgerekt, of op haar afstand van een einde</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Positie</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X van het midden</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y van het midden</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z van het midden</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X van de richting waarin ze kijkt, met lengte 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y van de richting waarin ze kijkt, met lengte 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z van de richting waarin ze kijkt, met lengte 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kijkt naar</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>Punt</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>Greep ervoor</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Hoek ervoor</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Greep erna</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Hoek erna</translation>
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
        <translation>Soort</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Vloeiend</translation>
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
        <translation>Voorinstelling</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>gewijzigd</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Naam van de voorinstelling</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, vier planken …</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Wat nu is ingesteld als voorinstelling bewaren</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Deze voorinstelling verwijderen</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Als voorinstelling bewaren</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Geeft wat nu is ingesteld een naam, zoals A5, om erop terug te komen</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 erbuiten</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 erbinnen</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 te hoog</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschappen</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>Nog %n onder Controles.</numerusform>
            <numerusform>Nog %n onder Controles.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Aan</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Uitgeschakeld maakt de operatie niets, maar ze bewaart haar instellingen</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>joint</comment>
        <extracomment>the names of two sections that meet</extracomment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is a mass or a force, %2 the name of a section</extracomment>
        <translation>%1 op %2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Niets geselecteerd</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Wijzigingen gelden voor alle</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Ze overlappen elkaar</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automatisch</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · met de hand ingesteld</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n verbinding</numerusform>
            <numerusform>%n verbindingen</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Gemaakt door %1 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Sectie · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Sectie · op %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · uitgeschakeld</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · maakt niets</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · actueel</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Recent geopend</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (ontbreekt)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Deze lijst wissen</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Deze namen vergeten; de bestanden blijven</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>Waar je op moet letten</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Sluit dit en selecteert het in het model</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Bestanden vervangen</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>%n bestaand bestand vervangen?</numerusform>
            <numerusform>%n bestaande bestanden vervangen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>Dit bestand vervangen?</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>horizontaal</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>Langs een rib, van ring tot ring</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>Langs een rib, tot de onderste ring</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Boog</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>opzij</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>as_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>as_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rug</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Balk</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Balken</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>Buikrib</translation>
    </message>
    <message>
        <source>between</source>
        <translation>tussen</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Plank</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Planken</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>planken</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Lijf</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Vertakking</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>hoofdletter</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellen</translation>
    </message>
    <message>
        <source>column</source>
        <translation>kolom</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolommen</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>kolommen</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Steun</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>steun</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Kuif</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Bestek</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>diepte</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diameter</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>hartafstand</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Tussenschot</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Tussenschotten</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Oren</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Achterste basis</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Achterste danser</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Achterste danser, voorover</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Achterste dansers</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Den</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Den, dwars</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Bodem</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Voet</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Voorpoten</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Vorken en theelepels</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Vier planken</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>Van as tot as, waterpas gemeten</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>Van as tot as, met wat speling</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>Van wand tot wand</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Voorkant</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Voorste voet</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Voorpoten</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Voorregel</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Voorste golf</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Glas water</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Greep</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kop</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hoogte</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Hoogte van de hoofdletters; een lange naam moet kleiner</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Hoogte van de steunen</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Hoogte van de as van het rondsel</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Hoogte van de as van het wiel</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Achterste voet</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Achterpoten</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Achterste golf</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Heup</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Gewei</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>Hoe ver een rib de bovenste ring opzij van zijn plek onderaan raakt</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>Hoe scheef elke rib staat</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>Hoeveel lager het rondsel zit, gezien vanaf het wiel</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Hoe breed het bordje is, in hoogtes van een hoofdletter</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>De breedte ervan</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Potjes</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Laatste rib</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Linkerpoot</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Linkerblad</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Linkerzijkant</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Linkerstrook</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Linkervleugel</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Poot</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Poten</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>poten</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>letters</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Lange voet</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>onder</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Onderste ring</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Onderste lat</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Midden</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Middelste basis</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Middelste danser</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Middelste danser, voorover</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Middelste dansers</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Middelste rib</translation>
    </message>
    <message>
        <source>module</source>
        <translation>moduul</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Mok</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Snuit</translation>
    </message>
    <message>
        <source>name</source>
        <translation>naam</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Naambordje</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Voorste basis</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Voorste danser</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Voorste danser, voorover</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Voorste dansers</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Nek</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>Van een rib, in de lengte gemeten</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>Van de planken, van eind tot eind</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Van de lade, binnenwerks</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Van het glas</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>Van de hoogste wand</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Van het rondsel, vanaf een tandholte die naar het wiel wijst</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Van het rondsel, net zo</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>Van de zijkanten</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>Van de zijkanten; de kuif steekt erboven uit</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>Van het wiel</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>Van het wiel, tot de bodem van de tandholtes</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>Van het wiel, tot de toppen van de tanden</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Andere voet</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Andere pijler</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Andere leuning</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere zijkant</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Andere onderligger</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Andere teen</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Pennen</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>fase</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>Pijler</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Rondsel</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>rondsel</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Rondseltanden</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>straal_rondsel</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>voetstraal_rondsel</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>rondsel_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Schild</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>bordje</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Schilden</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>straal</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Leuning</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Vinstraal</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Vinstralen</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Achterste rib</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>rest</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Rib</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Ribben</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>ribben</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Rechterpoot</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Rechterblad</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Rechterzijkant</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Rechterstrook</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Rechtervleugel</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Gatenring</translation>
    </message>
    <message>
        <source>root</source>
        <translation>voetstraal</translation>
    </message>
    <message>
        <source>row</source>
        <translation>rij</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rijen</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>rijen</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Schroeven</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Zitting</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Blad</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Schouder</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Zijkant</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Zijkanten</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Onderligger</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Maat van de tanden: de diameter gedeeld door hun aantal</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schijven</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Klein glas</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Ruggengraat</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Lepels en messen</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Ster</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Zon</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Staart</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Tanden</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>tanden</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Tanden van het rondsel</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>Hetzelfde, zonder hele tanden</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Drie planken</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>helling</translation>
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
        <translation>Teen</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Tand</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Stam</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>Drinkglas</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>draaiing</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Takje</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torsie</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Bovenste ring</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Bovenste lat</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Nekwervels</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Staartwervels</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Walvis</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>Wat er op de plaat past</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Wiel</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Waar een tand van het wiel zit</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Breed</translation>
    </message>
    <message>
        <source>width</source>
        <translation>breedte</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>breedtes</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Teckel</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Dennenboom</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Lampenkap</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Poppenstoel</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Glashouder</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Bureaubakje</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Plankenrek</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Ladeverdeler</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Naambordje</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Glasstandaard</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Beer over een mesh</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Uil naar afbeeldingen</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Egel in schijven</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Visgraten</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinosaurus</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Vliegend hert</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Groeiende boom</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Dansers in twee houdingen</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Loopbrug</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Tandwielen</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Walvis in cellen</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Bestekmannetje</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Glas op drie poten</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Drie dunne poten: te zwak</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Vier dunne poten: te zwak</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Drie dikke poten: maar net</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Vier dikke poten: veilig</translation>
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
        <translation>beginnen maken leeg blanco</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>laden importeren flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>toevoegen samenvoegen aanhangen combineren</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>bewaren schrijven</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>kopiëren hernoemen</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>herladen opnieuw laden weggooien</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>printen afdrukken lasersnijder lasersnijden cnc plotter svg dxf pdf gcode lightburn maken fabriceren</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>voorkeuren opties configureren donker licht thema taal eenheden inch muis navigatie reservekopie animatie</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>toetsen toetsenbord hotkeys sneltoets</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>stoppen verlaten einde</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf importeren</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf importeren graveren</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj afbeelding plaatje foto overtrekken natekenen achtergrond</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>terug oeps</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>nogmaals vooruit herhalen</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>klembord</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>kopiëren klonen verdubbelen</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>omdraaien spiegelen symmetrisch</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>verwijderen wissen weg prullenbak</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>zoeken vinden palet</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoomen centreren midden</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoomen focus</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>recht bovenop bekijken</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>orthografisch isometrisch parallel camera</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>doorzichtig transparant draadmodel doorkijken</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>doorsnede binnenkant helft</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>oppervlak schil omhulsel</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>solo alleen</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>weergeven zichtbaar</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>onzichtbaar</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>raster vloer bodem</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>delen geven doorgeven aanpassen configureren leerling klas schuif vergrendeld vol venster customizer</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>maximaliseren</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>zijbalken zijpanelen</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>indeling standaard</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>spiegelen helft</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>vloer bodem voeten grondvlak</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>magneet uitlijnen kleven hulplijn</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>veelhoek lijn kromme curve bezier pad</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>cirkel vierkant rechthoek veelhoek ster sleufgat</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>graveren tekst letters etsen opschrift</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>verplaatsen roteren draaien schalen grootte</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>opening venster raam uitsparing</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>vervangen</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>reeks patroon herhalen rij ribben</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>draaien rondom omwentelen</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>loft morph overgang ertussen</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>boom tak vork</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>wafel krat rooster</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>spaken wiel tandwiel polair</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>draaien roteren polair patroon</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>patroon herhalen kopieën</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>wafel lagen plakjes stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>converteren omzetten ontleden toepassen bakken</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>fout waarschuwing probleem</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>montage instructie handleiding animatie afspelen in elkaar zetten</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>sterkte breken simulatie natuurkunde fysica fem</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>belasting massa kracht</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>kracht belasting drukken</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>materiaal dikte triplex multiplex hout acrylaat plexiglas kerf snijbreedte</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>proefstukje kerf snijbreedte speling sleuven kam test</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>nesten indelen schikken</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>lengte afstand grootte maat</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>schalen grootte</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>handleiding uitleg documentatie gids</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>begin welkom voorbeelden</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>versie licentie</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Verbindingen</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Materiaal bewerken</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Dikte van het materiaal: alle secties van dit materiaal volgen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Zoals alle andere</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Hoe de onderdelen op de plaat mogen worden gedraaid: wat de vezelrichting volgt, ligt zoals getekend, of een halve slag gedraaid</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Een andere lengte rekt de contour uit rond haar sleuf, of haar midden</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punten</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Gaten</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
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
        <translation>Instellingen</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Groepen instellingen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Algemeen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Beeld</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Controles</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Toetsenbord</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Eenheden</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimeter (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centimeter (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Inch (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>Wat je ziet en typt. Bestanden bevatten altijd millimeters.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Zoals het systeem</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Donker</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoog contrast</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Geldt na opnieuw starten.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Startpagina tonen bij het starten</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Draaitijd</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Hoelang het beeld er tijdens het tekenen over doet om naar het nieuwe vlak te draaien. Bij 0 springt het.</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Beeld draait over</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>Bij 90° kijk je recht op het nieuwe vlak. Bij minder blijft de sectie waarop je begon zichtbaar.</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>Tekenlijn volgt sjabloon binnen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Muisknoppen zoals in</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Welke knoppen het beeld draaien, verplaatsen en zoomen. Ctrl met de linkerknop draait het altijd, spatie met de linkerknop verplaatst het.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Beweging</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Altijd</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>Zo weinig mogelijk</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Bij zo weinig mogelijk springt het beeld in plaats van te draaien.</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Spanningskleuren voor kleurenblinden</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>Van licht naar donker in plaats van blauw naar rood. Bij hoog contrast altijd zo.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Waarschuwen bij hoeken onder</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Hoe vlakker twee secties samenkomen, hoe breder hun sleuven moeten zijn.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Overlap negeren onder</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Een kleinere overlap dan dit is geen probleem.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Montagevolgorde zoeken gedurende</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>Op de achtergrond, na elke wijziging. Geef meer tijd als de controles geen volgorde vinden.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Veiligheidsfactor</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>Hoeveel keer zijn belasting een model moet dragen om als sterk genoeg te gelden.</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Kerffactor, hoogstens</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>Hoeveel keer hoger de spanning in binnenhoeken wordt gerekend.</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>Belasting blijft maandenlang</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Niet-opgeslagen werk bewaren om de</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Na een crash of stroomuitval krijg je het terug, ook als het nooit is opgeslagen. Je bestand blijft onaangeroerd.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Bij opslaan de vorige versie bewaren</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Eenvoudig venster</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Om te tekenen, te controleren en te exporteren; de rest is uit de weg.</translation>
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
        <translation>K40-laser</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>Hele multiplexplaat</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>Op de plaat</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Positie X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedraaid</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>blijft op zijn plaats</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Vastgepind</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P pint het geselecteerde onderdeel bij de platen vast of los</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>te groot voor één plaat</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, het eerste onderdeel</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm, om de maat te controleren</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Plaat, zoals die wordt gesneden</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Plus en min zoomen, de pijltjestoetsen verplaatsen de plaat, Home toont alles.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>Reststuk %1 blijft heel</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Platen</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Snel</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Goed</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Best</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Hoe goed onderdelen worden ingedeeld</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Snel legt alle onderdelen opnieuw neer. Goed duurt ongeveer tien seconden. Best gaat door tot je stopt.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Met Raster verdelen</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Alles lospinnen</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Teken een sectie en die ligt hier, klaar om te snijden.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Indelen…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Opnieuw indelen…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n vastgepind onderdeel had geen ruimte waar het lag.</numerusform>
            <numerusform>%n vastgepinde onderdelen hadden geen ruimte waar ze lagen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 is te groot voor de plaat.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 en nog %n zijn te groot voor hun platen.</numerusform>
            <numerusform>%1 en nog %n zijn te groot voor hun platen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Reststuk toevoegen</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n plaat meer dan er zijn</numerusform>
            <numerusform>%n platen meer dan er zijn</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · %2 snijden</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>behoudt het beste tot nu toe, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Indelen… %1 % gebruikt</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 op %2 · %3 % gebruikt · %4 snijden</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Platen, zoals ze worden gesneden</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Page Up en Page Down gaan van onderdeel naar onderdeel, de pijltjestoetsen verplaatsen een onderdeel 1 mm, R draait het, P pint het vast. Plus en min zoomen, Home toont alle platen.</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · %4° gedraaid</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>Er is geen ruimte voor.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>Zo weinig mag het niet worden gedraaid.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Het ligt zoals het is getekend.</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Plaat %1 van %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>Te groot</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>vezel ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n onderdeel · %1 % gebruikt</numerusform>
            <numerusform> · %n onderdelen · %1 % gebruikt</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Reststuk, plaat %1 van %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Vastgepind: blijft liggen waar het ligt. Klik om het los te pinnen.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Sleep een onderdeel ergens anders heen, of klik erop om het te selecteren.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Klik om &lt;b&gt;%1&lt;/b&gt; los te pinnen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; is te groot voor zijn plaat. Klik om het te selecteren.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sleep &lt;b&gt;%1&lt;/b&gt; ergens anders heen, of klik om het te selecteren.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sleep &lt;b&gt;%1&lt;/b&gt; ergens anders heen. &lt;kbd&gt;R&lt;/kbd&gt; draait het, &lt;kbd&gt;P&lt;/kbd&gt; pint het vast.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filter op naam of toetsen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Geen toetsen voor deze opdracht</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>De oorspronkelijke toetsen van deze opdracht</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alles herstellen</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>De oorspronkelijke toetsen van alle opdrachten</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>Hier gebruiken</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Opdrachten en hun sneltoetsen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Opdracht</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Sneltoets</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Werkt</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>in het beeld</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>overal</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Een opdracht kiezen</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Toetsen voor %1:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Door jou gewijzigd</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 alleen zou bij het typen in de weg zitten. Houd er Ctrl of Alt bij ingedrukt; losse toetsen zijn voor opdrachten die in het beeld werken.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 hoort bij “%2”.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Tussen %1 zou ze ver uitpuilen: nog een sectie dwars daarop zegt hoe ver.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Tussen %1 zou ze over zichzelf heen vouwen.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Wat tussen %1 ligt, is uit de contouren niet op te maken.</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Huid: bezig… %1&#x202f;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Huid: bezig…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Huid: gestopt</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Huid: niet te berekenen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Huid</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Huid: niets om te overdekken</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Huid: geen contouren kruisen elkaar</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Klik om te stoppen.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Een huid heeft secties nodig die elkaar kruisen en daar op dezelfde plek eindigen.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n lapje</numerusform>
            <numerusform>%n lapjes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; %n plek blijft open.</numerusform>
            <numerusform>%1; %n plekken blijven open.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Klik om weer alleen de secties te zien.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Recht</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rond</translation>
    </message>
    <message>
        <source>Dogbone</source>
        <translation>Dogbone</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>T-bone</translation>
    </message>
    <message>
        <source>Slit end</source>
        <translation>Sleufeinde</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>Het binnenste einde van een sleuf. Een laser snijdt het recht; de ronde frees van een freesmachine kan niet in de hoeken komen. Rond: een ronde bodem voorbij de rechte. Dogbone: een boog door elke hoek. T-bone: een boog in elke wand; de bodem blijft vlak.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Diameter van de frees. De bogen worden iets groter getekend, zodat de frees ze kan volgen.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Bij een recht einde hoort geen gereedschap. Kies voor een freesmachine een ander sleufeinde.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Inloop</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Afschuining van beide wanden bij de opening van een sleuf, onder 45°, zodat secties er makkelijk in schuiven. De halve tot de hele dikte is gebruikelijk; 0: geen.</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Klemnoppen</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Hoogte van een kleine nop op elke wand van een sleuf, die op de sectie erin drukt. Moet meer zijn dan de helft van de speling; 0: geen.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>sectie</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>gemaakte sectie</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>op %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>vergrendeld</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>heeft een probleem</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>geen probleem</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Verbinding van %1 en %2</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, operatie</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 op %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n sectie geselecteerd</numerusform>
            <numerusform>%n secties geselecteerd</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Startpagina</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nieuw</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Een eigen model tekenen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Openen…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Een model openen, ook uit FlatFab</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Geen account, niets verlaat deze computer.</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Tonen bij het starten</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recent</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Voorbeelden</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Hersteld: %1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Map tonen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>ontbreekt</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Uit deze lijst verwijderen</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>Als kopie openen</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Je eerste model in 3 minuten</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Een model tekenen, controleren en snijden, stap voor stap</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>Wat het volgende gebaar doet</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Aantal secties</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Grootte van het model</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Massa van het model</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Eenheden</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Eenheid van alle lengten</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>“%1” ongedaan gemaakt.</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>“%1” ongedaan gemaakt. &lt;kbd&gt;%2&lt;/kbd&gt; haalt het terug.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>“%1” opnieuw uitgevoerd.</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>“%1” opnieuw uitgevoerd. &lt;kbd&gt;%2&lt;/kbd&gt; maakt het ongedaan.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Montagestappen</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Stappen exporteren…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Stappen sluiten (Esc)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Vorige stap (links)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Afspelen (spatie)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Volgende stap (rechts)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>De onderdelen uit elkaar trekken</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Uit elkaar</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pauze (spatie)</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Alle stappen naar een PDF schrijven om te printen, naar een webpagina voor telefoons, of een afbeelding van elke stap</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Alle stappen, om te printen (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Afbeeldingen, één per stap (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Stappen exporteren</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 exporteren…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>Er is niets geschreven: de export is geannuleerd.</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>De stappen konden niet worden geëxporteerd: op dit scherm kan geen afbeelding worden gemaakt.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n stap</numerusform>
            <numerusform>%n stappen</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>%1 geëxporteerd naar %2.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>%1 geëxporteerd naar %2 … %3.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Ergens anders exporteren…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webpagina (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>Deze browser toont het model niet in 3D. Hier staat stap voor stap wat er te doen is.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>Er zijn geen afbeeldingen: op het scherm van de computer die deze pagina schreef, kon er geen worden gemaakt.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Sleep om het model te draaien, gebruik twee vingers of het wiel om te zoomen, tik twee keer om het helemaal te zien.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Afspelen</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Vorige stap</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Volgende stap</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Onderdelen</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 onderdeel</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n onderdeel</numerusform>
            <numerusform>%n onderdelen</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 plaat</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n plaat</numerusform>
            <numerusform>%n platen</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 stap</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n stap</numerusform>
            <numerusform>%n stappen</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Pagina %1 van %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>Zo gaat het in elkaar</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, uit %2, in %3.</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>Het zijn de nummers die in de onderdelen zijn gegraveerd. Bij elke sleuf staat na een kort streepje het nummer van de verbinding, op beide onderdelen hetzelfde.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>en nog %n</numerusform>
            <numerusform>en nog %n</numerusform>
        </translation>
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
        <source>The model has changed, so its steps are not shown.</source>
        <translation>Het model is gewijzigd, dus de stappen worden niet getoond.</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>De stappen kunnen op dit scherm niet worden getoond.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>De stappen worden niet getoond.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>De montagevolgorde wordt berekend; de stappen verschijnen zodra die bekend is.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>De stappen kunnen niet worden getoond: %1.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>De montagevolgorde is nu bekend; “Stappen tonen” laat die zien.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Er is nog niets.&lt;/b&gt; Stap 1: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1:&lt;/b&gt; %2</source>
        <extracomment>%1 is &quot;Step 4 of 38&quot;, %2 what is done in it</extracomment>
        <translation>&lt;b&gt;%1:&lt;/b&gt; %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::Stock</name>
    <message>
        <source>Birch plywood</source>
        <translation>Berkentriplex</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Berkentriplex 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Berkenmultiplex 6,5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Berkenmultiplex 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>Acrylaat</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>Acrylaat, helder</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Acrylaat, rood</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Golfkarton B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Golfkarton C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Golfkarton E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Karton</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Lindehout</translation>
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
        <source>Use %1 for new sections</source>
        <translation>%1 voor nieuwe secties gebruiken</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: %2 → %3 dik</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Materiaal van de volgende sectie</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Materiaal van de volgende sectie: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materialen…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Materialen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Plaat B × H</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichtheid</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>niet bekend</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 betekent niet bekend</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Prijs van een plaat</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Breedte van de plaat</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Hoogte van de plaat</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Gangbare platen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Sterkte</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Treksterkte</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Buigsterkte</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Stijfheid</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>voor het breekt</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Buigt</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Zoals metaal: boven deze sterkten blijft het gebogen</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Draagt maandenlang</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Deel van de sterkte bij een belasting die blijft: acrylaat kruipt en krijgt haarscheurtjes</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Snijden</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Snijbreedte (heel)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Speling sleuf</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Getekende sleuf</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Sleuven</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>niet beoordeeld</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 betekent niet beoordeeld</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>Er zijn geen secties van gemaakt</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>geen: de snijbreedte is groter dan de sleuf</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Dikte, speling en snijbreedte van twee secties van dit materiaal die haaks op elkaar staan</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Verkocht als</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>De dikte waaronder men de plaat koopt; meestal is ze niet precies zo dik</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>met een schuifmaat, door mij</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemeten</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>Exporteren vraagt één keer hoe dik de platen zijn die u gaat snijden</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>zoveel als nodig</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 betekent zoveel als nodig</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Hoeveel er zijn</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Eerst opgebruikt</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Een reststuk uit een tekening</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Tekeningen (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Per machine</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Bewaard waar een snijbreedte is getypt terwijl die machine bij het exporteren gekozen was</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Maat en aantal</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Materialen van dit model</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Een materiaal uit de voorinstellingen toevoegen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Een materiaal met dezelfde getallen toevoegen</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Dit materiaal in een bestand opslaan, voor andere modellen en andere mensen</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Het materiaal in een bestand opslaan</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Het materiaal verwijderen</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sectie</numerusform>
            <numerusform>%n secties</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Een model heeft een materiaal nodig; voeg eerst een ander toe</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Dit materiaal verwijderen</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Uit een bestand…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Een materiaal uit een bestand toevoegen</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>FlatFitFab-modellen (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>De %n sectie ervan maken van</numerusform>
            <numerusform>De %n secties ervan maken van</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Materiaal %1 toevoegen</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Materiaal %1 verwijderen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Opslaan…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
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
        <translation>Op de smalste plek</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>In de hoek ervan</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>Gebogen in het vlak</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Gebogen dwars op de plaat</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>In de lengte gedrukt</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>In de lengte getrokken</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Afgeschoven</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Verdraaid</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>Zo slank dat het kan knikken voordat het breekt.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Onzeker: er werken krachten naast de gaten waar het doorheen gaat.</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Een ruwe schatting: de smalste plek is te kort, of te dicht bij een kracht.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Het zou eerst in de hoek scheuren.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Het zou recht doormidden breken.</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressMarks</name>
    <message>
        <source>Stress</source>
        <translation>Spanning</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Veiligheidsfactor %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Sterkte onbekend</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Niets boven %1&#x202f;%</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>Beweging %1&#x202f;×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Het staat niet; er wordt geen spanning getoond.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Een verbinding wordt uit elkaar getrokken; er wordt geen spanning getoond.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Of het houdt, was niet te berekenen.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Secties zoeken…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Facetten maken…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Uitvouwen…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>%1 overtrekken…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>%n sectie gemaakt.</numerusform>
            <numerusform>%n secties gemaakt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Selecteer eerst de sectie waarin gaten komen, of leg de tekening erop.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Selecteer eerst de sectie die gegraveerd wordt, of leg de tekening erop.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Vlakken zoeken…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>ontbreekt</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>wordt telkens gelezen</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>bewaard in het model</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Bestand zoeken…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Lezen waar het bestand nu staat; het sjabloon blijft op zijn plaats</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Koppelen aan bestand…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>Uit het bestand van het model laten, dat kleiner wordt, en telkens lezen waar het staat</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>In het model bewaren</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>In het bestand van het model zetten, zodat het er ook op andere computers is</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>In het beeld verplaatsen, draaien en schalen, met grepen of getallen</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Maat met lijn</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Trek een lijn over iets erin waarvan je de lengte weet</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Verplaatsen en draaien</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Sjablonen</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Sjabloon toevoegen…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Een mesh, afbeelding of tekening inlezen om er secties naar te tekenen</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Voeg een mesh, afbeelding of tekening toe, of sleep of plak er een. Secties die je tekent, klikken vast waar hun vlak een mesh snijdt, en op de lijnen van een tekening in hun vlak.</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 hernoemt, spatie verbergt, L vergrendelt, Del verwijdert.</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Schijven…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>In secties snijden die de vorm volgen</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Plaats en grootte</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Dekking</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Afmeting</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>onbekend</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Op de grond</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Op de grond zetten</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Rechtop zetten</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Op de andere kant leggen: wat erin boven is, is ook in het beeld boven</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 ontbreekt</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Ontgrendelen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Vergrendelen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Positie</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X van het midden</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y van het midden</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z van het midden</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draaiing</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Gedraaid om X, als eerste</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Gedraaid om Y, na X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Gedraaid om Z, als laatste</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Mesh, %n driehoek</numerusform>
            <numerusform>Mesh, %n driehoeken</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Afbeelding, %1 × %2 pixels</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Tekening, %n lijn</numerusform>
            <numerusform>Tekening, %n lijnen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Sla over</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rondleiding stoppen</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Rondleiding</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Rondleiding, stap %1 van %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Kijk rond.&lt;/b&gt; Sleep naast het model om het te draaien; met het wiel kom je dichterbij.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Snijd het.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; toont de platen en schrijft het bestand voor de snijmachine.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Teken een lijf.&lt;/b&gt; Druk midden in het beeld en teken de omtrek in één haal, bovenaan vlak, tot op de grond.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Teken er een sectie dwars op.&lt;/b&gt; Druk in het lijf en sleep over de rand naar buiten. Houd de knop ingedrukt: het beeld draait. Teken dan de omtrek, weer tot op de grond.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Meet je plaat.&lt;/b&gt; Klik rechts op de werkbalk op het materiaal, dan op de dikte, en typ wat je hebt gemeten: alle sleuven volgen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;Werkt het?&lt;/b&gt; Dat zeggen de labels boven het beeld. Klik er een aan om meer te lezen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Herhaal haar.&lt;/b&gt; Kies &lt;b&gt;Rij&lt;/b&gt;, klik op de sectie dwars op het lijf en dan op het lijf: kopieën staan er op een rij langs.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Dat was de hele weg,&lt;/b&gt; van de eerste haal tot het bestand. Wat rood is, heeft onder Controles links die het verhelpen. Druk op &lt;b&gt;F1&lt;/b&gt; voor meer.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Bijna.&lt;/b&gt; Sleep de ronde greep aan het eind van de rij terug tot geen label meer rood is; dan schrijft &lt;b&gt;Export…&lt;/b&gt; het bestand voor de snijmachine.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;Dat is wel erg klein.&lt;/b&gt; Maak het ongedaan en teken het groter, ongeveer half zo breed als het beeld.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Hier eindigt de rondleiding.&lt;/b&gt; Via het menu &lt;b&gt;Help&lt;/b&gt; kun je haar opnieuw doen. Druk op &lt;b&gt;F1&lt;/b&gt; voor meer.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>Er kan geen reservekopie van niet-opgeslagen werk worden gemaakt voor het geval van een crash. Sla het voor de zekerheid op.</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Dit werk is in een ander venster geopend of weggegooid.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>De reservekopie kon niet worden geopend: %1.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>naamloos</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n stap</numerusform>
            <numerusform>%n stappen</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Een kopie van niet-opgeslagen werk is met een nieuwere FlatFitFab gemaakt; die blijft bewaard als %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Een kopie van niet-opgeslagen werk kon niet worden gelezen; die blijft bewaard als %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Geheel getal</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhouding</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Getal</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja of nee</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Keuze</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>small</source>
        <translation>klein</translation>
    </message>
    <message>
        <source>large</source>
        <translation>groot</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Keuzes</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>klein | groot</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Volgt uit</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groep</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>kop erboven</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Opmerking</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>waar het voor is</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Dit is niet te lezen als wat hier nodig is.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Soort</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>any</source>
        <translation>willekeurig</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Anderen kunnen dit aanpassen</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Is in te stellen waar het ontwerp is doorgegeven om aan te passen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>Wat ervan is gemaakt, worden gewone getallen</translation>
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
        <translation>Naam van de waarde</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Soort, bereik en opmerking</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Alleen voor jou</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>Het bereik is nu kleiner van: %1.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>De %n geprobeerde variant is goed.</numerusform>
            <numerusform>Alle %n geprobeerde varianten zijn goed.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is what is wrong, such as &quot;Falls over&quot;, %2 in how many places it is</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n variant(s) fail: %2.</source>
        <extracomment>%1 is a number, %2 a list such as &quot;Falls over (5), Breaks (2)&quot;</extracomment>
        <translation>
            <numerusform>%1 van %n variant voldoet niet: %2.</numerusform>
            <numerusform>%1 van %n varianten voldoen niet: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>Van de %1 hoeken zijn er %2 geprobeerd.</translation>
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
            <numerusform>en nog %n</numerusform>
            <numerusform>en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Bereiken proberen… %1 %</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Opnieuw proberen</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Alle bereiken proberen</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Bereiken inperken</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Zegt waar in de bereiken van de getoonde waarden het model niet in elkaar kan, breekt, omvalt of niet past.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>Waarden</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nieuwe waarde</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>waarde</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Dit ontwerp is gemaakt om aan te passen: stel de waarden in en exporteer het dan. Sleep in het beeld om het te draaien.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>Het wordt gesneden uit %1.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>In dit ontwerp valt niets aan te passen.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Ontwerp bewerken</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Doorgeven om aan te passen</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Tekenen en alle panelen terughalen; sla je nu op, dan gaat het bestand zo open.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Wie het opgeslagen model opent, ziet het beeld, de getoonde waarden en Exporteren, en verder niets.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Geef een getal een naam: elk veld kan die gebruiken, ook in sommen zoals = 2*speling.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Hoe het model wordt getoond</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Klik om de secties weer te zien zoals ze zijn.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Opengesneden</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Klik om weer het hele model te zien.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>BOVEN</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>ONDER</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>VOOR</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>ACHTER</translation>
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
        <translation>Beeld van het model</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Teken met de linkermuisknop, draai met de rechter.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 voor de werkplaats</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>De stappen zitten niet bij de bestanden: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Waar de map “%1” moet komen</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Hier neerzetten</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>op dit scherm kan geen afbeelding worden gemaakt.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Tekent vlakke onderdelen in 3D en snijdt ze.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modellen om te openen, elk in een venster; tekeningen, meshes en afbeeldingen om aan een nieuw model toe te voegen.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Opent FILE als kopie: opslaan vraagt om een naam.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Speelt een script af van drukken en bewegen.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>SCRIPT</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Start zonder wat is ingesteld, en bewaart geen instellingen.</translation>
    </message>
</context>
</TS>
