<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n część jako całość</numerusform>
            <numerusform>%n części jako całość</numerusform>
            <numerusform>%n części jako całość</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (część %2)</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (razem od kroku %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n inna</numerusform>
            <numerusform>%n inne</numerusform>
            <numerusform>%n innych</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>w górę</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>w dół</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>w prawo</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>w lewo</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>do przodu</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>do tyłu</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>zgodnie ze strzałką</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Nie ma jeszcze żadnej płytki, więc nie ma też kroków.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>Z tego modelu nic się nie wycina, więc nie ma kroków.</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Brak kroków do pokazania: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>Brak kroków do pokazania: nie udało się na czas znaleźć kolejności składania.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>Brak kroków do pokazania: modelu nie da się złożyć, bo %n płytka się blokuje.</numerusform>
            <numerusform>Brak kroków do pokazania: modelu nie da się złożyć, bo %n płytki blokują się nawzajem.</numerusform>
            <numerusform>Brak kroków do pokazania: modelu nie da się złożyć, bo %n płytek blokuje się nawzajem.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>Brak kroków do pokazania: modelu nie da się złożyć, bo blokują się nawzajem części: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>Brak kroków do pokazania: modelu nie da się złożyć, bo %1 blokują się nawzajem.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Krok %1 z %2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>zacznij od: %1</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>zacznij osobną grupę od: %1</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>połóż na miejscu: %1</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>wprowadź okrężną drogą, na koniec %2: %1</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>wprowadź okrężną drogą, potem wsuń %2: %1 → %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>przesuń %2 na miejsce: %1</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>wsuń %2: %1 → %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Utrzyma tu jeszcze %1, potem %2 pęknie %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Utrzyma tu %1, potem %2 pęknie %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Utrzyma tu jeszcze %1, potem się przewróci.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Utrzyma tu %1, potem się przewróci.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Utrzyma tu jeszcze %1, potem rozsunie się połączenie.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Utrzyma tu %1, potem rozsunie się połączenie.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Utrzyma tu więcej niż %1.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>Nie udało się obliczyć, ile tu utrzyma.</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Poszerz podstawę</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Dodaj stopkę</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Połączone. Na razie tylko jedna płytka.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 połączenie</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n połączenie</numerusform>
            <numerusform>%n połączenia</numerusform>
            <numerusform>%n połączeń</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Połączone. Obie płytki, %1.</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Połączone. Wszystkie płytki (%1), %2.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Byłoby połączone, %1.</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 nie łączy się z resztą.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 nie łączą się z resztą.</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 styka się z „%2”, ale nic ich nie łączy.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 stykają się z „%2”, ale nic ich nie łączy.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Nic nie dotyka „%1”. Odległość do „%3”: %2.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Nic innego nie dotyka: %1. Odległość do „%3”: %2.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Usuń wszystkie</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Połączone</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Byłoby połączone</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Niepołączone</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Narysuj płytkę, która przecina obie, albo dosuń jedną do drugiej.</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Jeszcze niepołączone</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>gdyby trzymało się razem</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>gdyby nic się nie rozpadało</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>gdyby rzaz nie zamykał żadnej szczeliny</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>gdyby żadna szczelina nie była za ciasna</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>gdyby żadna szczelina nie była za szeroka</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>gdyby się nie kładło</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>gdyby się nie ześlizgiwało</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>gdyby nic się nie obluzowało</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>gdyby żadne połączenie się nie rozsuwało</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>gdyby nic na to nie naciskało</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>Zakończ jedną na drugiej</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>Zakończ „%1” na „%2”</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>Ich połączenie jest ustawione na „Brak”.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Żadna szczelina nie pozwala ich w siebie wsunąć: ujemny luz nie zostawia jej szerokości. Zwiększ luz.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Żadne szczeliny nie pozwalają ich w siebie wsunąć: w jednym miejscu dałoby się je wsunąć tylko w jedną stronę, w innym tylko w drugą. Skróć jedną z nich.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Nic by ich nie trzymało: tam, gdzie zaczynałyby się szczeliny, są otwory. Zmniejsz otwory albo niech jedna kończy się wewnątrz drugiej.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Żadna szczelina nie pozwala ich w siebie wsunąć: żadna z nich nie sięga krawędzi. Otwórz któryś otwór na zewnątrz albo niech jedna przejdzie na wylot.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 i %2 przenikają się na długości %3. %4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>mniej niż %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 i %2 przenikają się o %3 poza swoimi szczelinami.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 i %2 przenikają się o %3, ale nie są połączone.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 i %2 leżą prawie w jednej płaszczyźnie: spotykają się pod kątem %3, a poniżej %4 żadna szczelina ich nie utrzyma.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 i %2 spotykają się pod kątem %3; poniżej %4 szczeliny robią się szerokie.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Odsuń jedną z nich albo niech kończy się przed drugą.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Płytki się przenikają</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Za płaski kąt</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Ustaw jedną z nich bardziej prostopadle do drugiej.</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Połącz je</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Połącz z „%1”</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Połącz je z „%1”</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przesuń do „%1”</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Przesuń je do „%1”</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przytnij „%1”</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Połącz wypustami</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 nie trzyma „%2”: szczelina biegnie wzdłuż krawędzi i ma materiał tylko po jednej stronie.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 nie trzyma „%2”: szczeliny przecinają tam płytkę na wylot.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 nie trzyma „%2”: szczelina ma mniej niż %3 głębokości.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 nie trzyma „%2”: szczelina nie zostawia materiału po żadnej stronie.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 nie trzyma „%2”: inne szczeliny zabierają to, co tkwiłoby w tej szczelinie.</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Odsuń szczelinę od krawędzi.</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Niech jedna z krzyżujących się tam płytek kończy się przed innymi, albo odsuń ją na bok.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>Szczelina nic nie trzyma</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>%1: szczeliny rozcinają płytkę na części (%2)</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 wychodzi w kilku częściach (%2)</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; jednej z nich, %2, nic nie trzyma.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nic ich nie trzyma, największa ma %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1; niektórych (%2) nic nie trzyma, największa ma %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>Szczeliny rozcinają: %1. To, co odcięte, trzyma się razem, ale nic tego nie podtrzymuje.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>Szczeliny rozcinają: %1. Tego, co odcięte, nic nie trzyma, razem z: %2.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>%1: szczeliny rozcinają płytkę. Nic nie trzyma kawałka %2, na którym są: %3.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Odwróć szczeliny</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Luźne części</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Odsuń „%1” od krawędzi</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Odsuń „%1”</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Spłyć szczelinę</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>Szczelinę %1 zamyka rzaz %2. Zwiększ luz szczelin materiału albo zmniejsz rzaz.</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>Szczelina %1 jest węższa niż narzędzie %2. Zwiększ luz szczelin materiału lub wybierz cieńsze narzędzie.</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Między garbkami szczeliny są o %1 węższe niż to, co w nie wchodzi. To za ciasno dla każdego materiału: zmniejsz garbki.</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>Szczeliny są o %1 węższe niż to, co w nie wchodzi. To za ciasno dla każdego materiału.</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>Szczeliny są o %1 szersze niż to, co w nie wchodzi, więc będzie luźno.</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Ustaw luz</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Szczeliny za ciasne</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Szczeliny za szerokie</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Szczelina węższa niż narzędzie</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Spróbuj ponownie</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Pokaż kopię do zgłoszenia</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Nie obliczono</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Da się złożyć. Na razie tylko jedna część.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Da się złożyć. Ale jednej z części nic nie trzyma.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Da się złożyć. Ale %n części nic nie trzyma.</numerusform>
            <numerusform>Da się złożyć. Ale %n części nic nie trzyma.</numerusform>
            <numerusform>Da się złożyć. Ale %n części nic nie trzyma.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Da się złożyć. %n krok.</numerusform>
            <numerusform>Da się złożyć. %n kroki.</numerusform>
            <numerusform>Da się złożyć. %n kroków.</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Dałoby się złożyć, %1.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Jeszcze nie da się złożyć. Dałoby się, gdyby dwie płytki się nie przenikały.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Jeszcze nie da się złożyć. Dałoby się, gdyby %n para płytek się nie przenikała.</numerusform>
            <numerusform>Jeszcze nie da się złożyć. Dałoby się, gdyby %n pary płytek się nie przenikały.</numerusform>
            <numerusform>Jeszcze nie da się złożyć. Dałoby się, gdyby %n par płytek się nie przenikało.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Pokaż kroki</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>Płytki blokują się nawzajem. %1: %2, które wsuwają się w różnych kierunkach (%3).</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>Płytki blokują się nawzajem. %1 wysuwa się ze szczeliny tylko o %2, a potem zawadza o „%3”.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>Płytki blokują się nawzajem. Żadnej z nich nie da się wysunąć po prostej: %1.</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Umożliw złożenie</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>Odwrócono 1 połączenie.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>Odwrócono %n połączenie.</numerusform>
            <numerusform>Odwrócono %n połączenia.</numerusform>
            <numerusform>Odwrócono %n połączeń.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Nie znaleziono kolejności: %1.</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Nie znaleziono kolejności. Szukanie trwało zbyt długo; o samym modelu to nic nie mówi.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Da się złożyć</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Dałoby się złożyć</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Jeszcze nie da się złożyć</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>Nie da się złożyć</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Skróć jedną z nich albo obróć ją tak, aby wsuwała się w tym samym kierunku co inne.</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Nie znaleziono kolejności</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Rozsuwa się. Połączenie „%1” i „%2” rozciąga siła %3 N.</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>Niczego nie przenosi. Połączenie „%1” i „%2” rozciąga siła %3 N; inne trzymają bez niego.</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Trzyma tylko tarcie. Połączenie „%1” i „%2” jest ciągnięte siłą %3 N, którą utrzyma tylko ciasne pasowanie.</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Rozsuwa się</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>Niczego nie przenosi</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>Odwróć jej szczeliny</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Sklej to.</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Trzyma tylko tarcie</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Przewraca się od nacisku. Bez nacisków by stało.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Przewraca się od nacisku</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Poszerz podstawę, dodaj ciężaru albo naciskaj słabiej lub niżej.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 łączą się w pierścień: składaj je w kolejności kroków.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 łączą się w pierścień: ta, która wchodzi ostatnia, musi wsunąć się na dwie inne naraz.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Płytki łączą się w %n pierścień: składaj je w kolejności kroków.</numerusform>
            <numerusform>Płytki łączą się w %n pierścienie: składaj je w kolejności kroków.</numerusform>
            <numerusform>Płytki łączą się w %n pierścieni: składaj je w kolejności kroków.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Płytki łączą się w %n pierścień: ta, która wchodzi ostatnia, musi wsunąć się na dwie inne naraz.</numerusform>
            <numerusform>Płytki łączą się w %n pierścienie: w każdym ta, która wchodzi ostatnia, musi wsunąć się na dwie inne naraz.</numerusform>
            <numerusform>Płytki łączą się w %n pierścieni: w każdym ta, która wchodzi ostatnia, musi wsunąć się na dwie inne naraz.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>Połączone w pierścień</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Podeprzyj stopką</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 arkusz</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n arkusz</numerusform>
            <numerusform>%n arkusze</numerusform>
            <numerusform>%n arkuszy</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Mieści się na arkuszu. %1, wykorzystanie %2%.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Mieści się na arkuszu. %1, %2, wykorzystanie %3%.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>Liczba części, które nie mieszczą się na żadnym arkuszu %3 z marginesem %4, jakkolwiek je obrócić: %1 (%2).</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 ma wymiary %2 i w żadnym obrocie nie mieści się na arkuszu %3 z marginesem %4.</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Wybierz arkusz</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Mieści się na arkuszu</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>Za duże na arkusz</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Przedłuż je do podłoża</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przedłuż „%1” do podłoża</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Postaw na podłożu</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Podnieś na podłoże</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Stoi, ale kiwa się o %1. Wywróci się dopiero powyżej %2. Zapas %3.</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Stoi. Wywróci się dopiero powyżej %1. Zapas %2.</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Stoi, ale krzywo, o %1. Wywróci się dopiero powyżej %2. Zapas %3.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>Najniższy punkt „%1” jest %2 nad podłożem.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>%1: najniższe punkty są do %2 nad podłożem.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Przechyla się o %1 do przodu</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Przechyla się o %1 do tyłu</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Przechyla się o %1 w lewo</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Przechyla się o %1 w prawo</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Kiwa się o %1: nie wszystkie najniższe punkty są na podłożu. Wywróci się dopiero powyżej %2.</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1, zanim stanie: nie wszystkie najniższe punkty są na podłożu. Wywróci się dopiero powyżej %2.</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Stałoby, %1. Wywróciłoby się dopiero powyżej %2. Zapas %3.</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Przewróci się od dotknięcia: wystarczy przechył o %1. Zapas %2.</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Ledwo stoi: wywróci się przy przechyle o %1. Zapas %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Kiwa się</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Stoi krzywo</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Przewróci się od dotknięcia</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Łatwo się wywraca</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Przewraca się do przodu. Środek masy leży %1 przed stopkami.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Przewraca się do tyłu. Środek masy leży %1 za stopkami.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Przewraca się na lewą stronę. Środek masy leży %1 poza stopkami.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Przewraca się na prawą stronę. Środek masy leży %1 poza stopkami.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Przewraca się. Wszystkie stopki leżą na jednej linii, więc nic nie trzyma modelu w pionie.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>Nie stoi na podłożu. Najniższy punkt tych płytek jest %1 nad nim.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>Nie stoi na podłożu. Najniższy punkt jest %1 nad nim.</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Dodaj stopkę albo przesuń ciężar nad stopki.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Połącz z tym, co stoi, albo postaw na podłożu.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Jeszcze nie stoi</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Jeszcze nie na podłożu</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Stoi</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Stałoby</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Niech wszystkie stopki kończą się na tej samej wysokości.</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Przewraca się</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>Nie stoi na podłożu</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 razy tyle</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>własne obciążenie</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Dość mocne</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Utrzyma %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Byłoby dość mocne</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Utrzymałoby %1</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Może pęknąć</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Ledwo dość mocne</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Może pęknąć przez %1</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Ledwo utrzyma %1</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Złamie się</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Za słabe</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Złamie je %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Za słabe na %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 złamie się %2 od %3.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 może pęknąć %2 od %3;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>przewężenie złamie się przy %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>przewężenie „%1” złamie się przy %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 może pęknąć %2 od %3.</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Wystarczy %1, aby rozsunęło się połączenie.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Wystarczy %1, aby przestało stać.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Utrzymałoby znacznie więcej.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>Nie udało się obliczyć, ile by utrzymało.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>Nic tego nie obciąża.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Najsłabsze miejsce: %1, %2: mniej niż 1% wytrzymałości.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>Najsłabsze miejsce: %1, %2: %3% wytrzymałości.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Ugina się o %1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>Przewężenie „%1” jest obciążone do %2% wytrzymałości.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>To mniej, niż wymaga współczynnik bezpieczeństwa %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Wytrzymałość nieznana. Nie podano wytrzymałości materiału dla: %1.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Wytrzymałość nieznana. Nie udało się obliczyć sił między płytkami.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Wytrzymałość nieznana. Nie udało się obliczyć naprężeń dla: %1.</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Ześlizguje się. Stopki nie opierają się temu, co naciska: naciskaj słabiej albo dodaj ciężaru.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Obluzowuje się. Nic nie trzyma na miejscu: %1. Sklej połączenia albo dodaj jeszcze jedno.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Kładzie się. Wczepy obracają się jak zawiasy i nic więcej nie trzyma: %1. Sklej je albo połącz z jeszcze jedną płytką.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Poza materiałem. Ciężar na „%1” nie trafia w materiał; przejmuje go najbliższe miejsce.</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Użyj grubszego materiału, poszerz tam płytkę albo połóż na niej mniej.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Wytrzymałość nieznana</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Obluzowuje się</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Kładzie się</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Poza materiałem</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Użyj materiału grubości %1</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Użyj grubszego materiału</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Podaj wytrzymałość</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Rozpada się. %1 trzyma się na mniej, niż da się wyciąć.</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Za mało materiału. %1 ma w jednym miejscu tylko %2 szerokości.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Rozpada się</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Poszerz tam płytkę albo rozsuń to, co się styka.</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Za mało materiału</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Poszerz tam płytkę.</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: zachodzą na siebie szczeliny dla: %2.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: między szczelinami dla: %2 nic nie zostaje.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: między szczeliną dla „%2” a otworem nic nie zostaje.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: między szczeliną dla „%2” a krawędzią nic nie zostaje.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: między szczelinami dla: %3 zostaje tylko %2 materiału.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: między szczeliną dla „%3” a otworem zostaje tylko %2 materiału.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: między szczeliną dla „%3” a krawędzią zostaje tylko %2 materiału.</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Dość cienkie</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Poszerz tam płytkę albo przesuń szczelinę.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Szczeliny zachodzą na siebie</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Masa %1. Środek masy leży %2 nad podłożem.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 i %2 tylko się stykają: przenikają się o mniej niż %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n para płytek tylko się styka: przenikanie poniżej %1.</numerusform>
            <numerusform>%n pary płytek tylko się stykają: przenikanie poniżej %1.</numerusform>
            <numerusform>%n par płytek tylko się styka: przenikanie poniżej %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Tylko się stykają</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Obróć „%1” do 90°</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Szczeliny odcinają od „%1” okruch mniejszy niż 1 mm². To odpad i nie dostaje numeru.</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Szczeliny odcinają %n okruch mniejszy niż 1 mm² (%1). To odpad i nie dostaje numeru.</numerusform>
            <numerusform>Szczeliny odcinają %n okruchy mniejsze niż 1 mm² (%1). To odpad i nie dostają numerów.</numerusform>
            <numerusform>Szczeliny odcinają %n okruchów mniejszych niż 1 mm² (%1). To odpad i nie dostają numerów.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Odpad</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>%1: szczeliny dzielą płytkę na %2, które trzymają inne płytki.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n część</numerusform>
            <numerusform>%n części</numerusform>
            <numerusform>%n części</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>Szczeliny nie zostawiają nic z: %1.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>%1: nie udało się wyciąć, bo nie udało się obliczyć, co zostawiają szczeliny. Nic nie można wyeksportować; masa jest liczona bez szczelin.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: nie udało się obliczyć, brakuje płytek tej operacji. Nic nie można wyeksportować.</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Pocięte szczelinami</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>Nic nie zostaje</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Nie wycięto</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>Operacja się nie powiodła</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Poszerz tam</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>przesunięto %n płytkę</numerusform>
            <numerusform>przesunięto %n płytki</numerusform>
            <numerusform>przesunięto %n płytek</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>przesunięto %n płytkę w dół o %1</numerusform>
            <numerusform>przesunięto %n płytki w dół o %1</numerusform>
            <numerusform>przesunięto %n płytek w dół o %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>przesunięto %n płytkę w górę o %1</numerusform>
            <numerusform>przesunięto %n płytki w górę o %1</numerusform>
            <numerusform>przesunięto %n płytek w górę o %1</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>odwrócono 1 połączenie</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>odwrócono %n połączenie</numerusform>
            <numerusform>odwrócono %n połączenia</numerusform>
            <numerusform>odwrócono %n połączeń</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1: grubość zmieniona na %2</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>Szczeliny 1 połączenia spotykają się gdzie indziej</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>Szczeliny %n połączenia spotykają się gdzie indziej</numerusform>
            <numerusform>Szczeliny %n połączeń spotykają się gdzie indziej</numerusform>
            <numerusform>Szczeliny %n połączeń spotykają się gdzie indziej</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1: przesunięto o %2</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1: obrócono o %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>obrócono %n płytkę</numerusform>
            <numerusform>obrócono %n płytki</numerusform>
            <numerusform>obrócono %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>nowe połączenie ze szczeliną %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 nowe połączenie</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n nowe połączenie</numerusform>
            <numerusform>%n nowe połączenia</numerusform>
            <numerusform>%n nowych połączeń</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>zmieniono obrys: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>zmieniono obrys %n płytki</numerusform>
            <numerusform>zmieniono obrys %n płytek</numerusform>
            <numerusform>zmieniono obrys %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>dodano: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>dodano %n płytkę</numerusform>
            <numerusform>dodano %n płytki</numerusform>
            <numerusform>dodano %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>usunięto: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>usunięto %n płytkę</numerusform>
            <numerusform>usunięto %n płytki</numerusform>
            <numerusform>usunięto %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>nic więcej nie zostaje przecięte</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>rozwiązano 1 problem</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>rozwiązano %n problem</numerusform>
            <numerusform>rozwiązano %n problemy</numerusform>
            <numerusform>rozwiązano %n problemów</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>wtedy: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>nowe: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n nowa uwaga</numerusform>
            <numerusform>%n nowe uwagi</numerusform>
            <numerusform>%n nowych uwag</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>przy szczelinie dla „%1”</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>w miejscu połączenia z „%1”</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>w wewnętrznym narożniku</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>w przewężeniu</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>Połączone w pierścienie</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>W podłożu. %1 sięga %2 poniżej.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>W podłożu. %1 sięgają do %2 poniżej.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>W podłożu</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Przesuń płaszczyzny o %1 %</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>O jedną płaszczyznę więcej w każdym kierunku</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Mieści się na arkuszach i resztkach, które są.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>Najwyżej %n arkusz</numerusform>
            <numerusform>Najwyżej %n arkusze</numerusform>
            <numerusform>Najwyżej %n arkuszy</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Mieści się na arkuszu. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Mieści się na arkuszu. %1, %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Płytki lekko się przenikają</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>Może zabraknąć arkuszy. Potrzeba do %n arkusza materiału %1, a jest %2.</numerusform>
            <numerusform>Może zabraknąć arkuszy. Potrzeba do %n arkuszy materiału %1, a jest %2.</numerusform>
            <numerusform>Może zabraknąć arkuszy. Potrzeba do %n arkuszy materiału %1, a jest %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>Może zabraknąć arkuszy</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Zobacz w panelu Arkusze, jak ciasno mogą leżeć części.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Płaszczyzny co %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, z przesunięciem o %2%</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>O jedną płaszczyznę więcej</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>O jedną płaszczyznę mniej w każdym kierunku</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>O jedną płaszczyznę mniej</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>O dwie płaszczyzny więcej w każdym kierunku</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>O dwie płaszczyzny więcej</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>O dwie płaszczyzny mniej w każdym kierunku</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>O dwie płaszczyzny mniej</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Żadne z wypróbowanych przesunięć i liczb płaszczyzn nie pozwala ich zsunąć. Utrwal plastry i skróć jedną z nich albo ją usuń.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>Model jest tu do dopasowania; „Edytuj projekt” przywraca wszystko</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Otwórz…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Otwiera model, także z FlatFab</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>Wstaw model…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Wstaw</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>Dodaje płytki z innego modelu do tego</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>Podkład do odrysowania…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Podkład</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Wczytuje siatkę, obraz lub rysunek, po którym można rysować płytki</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>Dodaj do biblioteki</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>Do biblioteki</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>Przechowuje zaznaczenie w bibliotece, dla innych modeli</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Zapisuje model</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Zapisz jako…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Zapisz jako</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Zapisuje model pod inną nazwą</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Eksportuj pliki do cięcia…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksportuj…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>Zapisuje części w pliku dla wycinarki laserowej</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Eksportuj ponownie</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Eksportuj ponownie</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Zapisuje jeszcze raz ten sam plik z tymi samymi opcjami</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Przywróć zapisany</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Wraca do modelu takiego, jaki jest w pliku; Cofnij przywraca zmiany</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Ustawienia…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Jednostki, kolory, język, pliki i skróty</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Skróty klawiszowe…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Skróty</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Sprawdź, które klawisze co robią, i wybierz własne</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Zamknij okno</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Zamyka to okno; inne zostają otwarte</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Zakończ</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Zakończ</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Zamyka wszystkie okna i program</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Przejdź do właściwości</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Właściwości</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Przechodzi do pierwszego pola zaznaczenia; w widoku robi to samo Enter</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Ukryj wszystkie panele</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Ukryj panele</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>Ukrywa lub pokazuje panele po bokach</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Pełny ekran</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Pełny ekran</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Wypełnia ekran oknem programu</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Przywróć układ okna</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Przywróć układ okna</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Ustawia wszystkie panele na pierwotnych miejscach</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Następna część okna</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Następna</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Przechodzi do następnej części okna: pasek narzędzi, lewa strona, widok, prawa strona</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Poprzednia część okna</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Poprzednia</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Wraca do poprzedniej części okna</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>Następny problem</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Następny problem</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>Zaznacza i pokazuje płytki następnego problemu</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>Poprzedni problem</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Poprzedni problem</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>Zaznacza płytki poprzedniego problemu</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Pokaż kroki</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Pokazuje krok po kroku, jak złożyć model</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Materiały…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Materiały w arkuszach: grubość, wytrzymałość, rzaz i rozmiar arkusza</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Próbka pasowania…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Próbka</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Zapisuje próbkę, która pokaże, jakie szczeliny pasują i jak szeroko tnie maszyna</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>Arkusze</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Arkusze</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>Pokazuje części na arkuszach tak, jak będą wycięte</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Przejdź do wartości</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>Zmienia wartości, z których powstają liczby modelu</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nowa wartość</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Liczba z nazwą, którą przyjmują pola liczbowe</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Znajdź polecenie…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Znajdź</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Wpisz, aby znaleźć wszystko, co potrafi program</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>Pierwsze kroki</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Pierwsze kroki</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Jak powstaje model, krok po kroku, z obrazkami</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Strona startowa</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Strona startowa</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Ostatnie modele i przykłady</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>O FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>O programie</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>Co to za program, jego wersja i licencje</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Nie było jeszcze eksportu</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Nie było jeszcze zapisu</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Od zapisu nic się nie zmieniło</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Mapa nośności</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Mapa nośności</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Koloruje płytkę według masy, jaką utrzyma każde jej miejsce</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Najpierw zaznacz płytkę, którą chcesz obejrzeć</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Najpierw zaznacz jedną płytkę</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>Nie zaznaczono połączenia: zaznacz płytkę, potem jedno z jej połączeń</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>Nie ma innej płytki</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>Nie zaznaczono operacji</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Nie ma jeszcze żadnej płytki</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>Nie zaznaczono płytki</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Wytnij</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Wytnij</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>Kopiuje zaznaczone płytki i je usuwa</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>Kopiuje zaznaczone płytki, także do innych okien i programów</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Wklej</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Wklej</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>Dodaje skopiowane płytki albo obraz do odrysowania</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Powiel</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Powiel</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>Umieszcza obok kopię zaznaczonych płytek</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>Względem X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>Odbij X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Umieszcza lustrzane odbicie zaznaczonych płytek po drugiej stronie płaszczyzny, na której X równa się 0</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>Względem Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Odbij Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Umieszcza lustrzane odbicie zaznaczonych płytek po drugiej stronie płaszczyzny, na której Y równa się 0</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>Względem Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Odbij Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Umieszcza lustrzane odbicie zaznaczonych płytek po drugiej stronie płaszczyzny, na której Z równa się 0</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>Względem płytki…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Odbij</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Kliknij płytkę: odbicie zaznaczonych pojawi się po jej drugiej stronie</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Płytki z SVG…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>Z SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Płytka z każdego obrysu na rysunku</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>Kontur z SVG…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Kontur z SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>Największy obrys rysunku zamiast konturu zaznaczonej płytki</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>Otwory z SVG…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Otwory z SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Otwór w zaznaczonej płytce z każdego obrysu na rysunku</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>Znaki z SVG…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Znaki z SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>Linie rysunku grawerowane lub nacinane na zaznaczonej płytce</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Narysuj figurę</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Figura</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Koło, prostokąt i podobne, przeciągane od środka</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>Koło</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Koło</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>Według liczb: otwór w zaznaczonej płytce albo osobna płytka</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>Elipsa</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipsa</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Prostokąt</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Prostokąt</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Wielokąt</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Wielokąt</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>Gwiazda</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Gwiazda</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>Fasolka</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Fasolka</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Przesuń podkład</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Uchwyty</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Przesuwa, obraca i skaluje podkład uchwytami albo według liczb</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Rozmiar podkładu według linii</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Według linii</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Narysuj linię na podkładzie i podaj jej długość</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>Nie ma obrazu ani rysunku: najpierw dodaj jedno z nich</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>Nie ma podkładu: najpierw dodaj siatkę lub obraz</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Odwróć szczeliny połączenia</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Odwróć</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>Szczeliny zaznaczonego połączenia otwierają się w drugą stronę</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Przywróć ustawienia automatyczne</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Automatyczne</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Rodzaj, kierunek i punkty styku zaznaczonego połączenia znowu wybiera program</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>W tym połączeniu nic nie ustawiono ręcznie</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>Dodaj ciężar</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Ciężar</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Kładzie ciężar na płytce, aby sprawdzić, ile utrzyma</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>Dodaj nacisk</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Nacisk</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>Naciska lub ciągnie płytkę w jednym miejscu, aby sprawdzić, ile utrzyma</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>Pociągnij tutaj</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Pociągnij</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Pociągnij płytkę myszą i zobacz, co się stanie; nic nie zostaje</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Na model nic nie działa: najpierw dodaj ciężar lub nacisk</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>Nie ma siatki, którą można by dociągnąć</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Dodaj tekst lub linie do grawerowania</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Graweruj</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Pisanie lub rysowanie na płytce, do grawerowania lub nacinania</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>Graweruj</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>To, co teraz narysujesz, będzie grawerowane</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>Nacinanie</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Nacinanie</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>To, co teraz narysujesz, będzie nacinane, do zginania lub łamania</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Zmierz</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Zmierz</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>Mierzy między dwoma miejscami; długość można zachować albo przeskalować do niej model</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Skaluj do długości</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Skaluj do długości</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Ustala długość i skaluje do niej model</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Zachowaj długość</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Zachowaj</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Nadal pokazuje tę długość</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Usuń ten wymiar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Usuń ten wymiar</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>Nic nie zmierzono</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>Nie wybrano wymiaru: kliknij go narzędziem „Zmierz”</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>Odbij…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>Odbija zaznaczone płytki albo jedną stronę modelu na drugą</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Odbij w lewo i w prawo (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>Odbija względem płaszczyzny, na której X równa się 0</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Odbij w górę i w dół (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Odbija względem płaszczyzny, na której Y równa się 0</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Odbij do przodu i do tyłu (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Odbija względem płaszczyzny, na której Z równa się 0</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>Odbij względem płytki</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Płytka</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>Odbija względem płaszczyzny klikniętej płytki</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Odbita kopia zaznaczenia</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Dodaje lustrzane odbicie zaznaczonych płytek</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Utrzymuj obie strony takie same</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Obie strony</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Odbija wszystko narysowane po jednej stronie, teraz i później</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Nadaj symetrię raz</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Raz</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>Kopiuje jedną stronę na drugą; późniejsze zmiany nie są kopiowane</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Odbij tak, jak pokazano</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Wykonuje to, co pokazano</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Najpierw wybierz „Odbij”</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>Przyjmij proponowany kształt</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Przyjmij</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Zmienia to, co właśnie narysowano, w proponowane koło, elipsę, proste linie lub kąty proste albo odsuwa szczelinę od krawędzi</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>Weź całą prowadnicę</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Prowadnica</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>Tworzy płytkę ze wszystkiego, co jej płaszczyzna wycina z podkładu, razem z otworami</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>Do tego, co właśnie narysowano, nie ma propozycji</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>Płaszczyzna, na której się rysuje, nie przecina żadnego podkładu</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>Rząd</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Rząd</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>Powtarza płytkę w rzędzie wzdłuż innej płytki</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>Po obwodzie konturu</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Po obwodzie</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Powtarza płytkę wokół konturu innej płytki</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Przejście</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Przejście</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Tworzy przejścia między płytkami</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>Gałęzie</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Gałęzie</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Z płytki wyrastają jej kopie, jak w drzewie</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Podział z łącznikami</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Podział</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Dzieli płytkę, która jest za duża na arkusz</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>Kontur kołowy</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Kołowy</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>Zmienia płytkę w koło, gwiazdę lub koło zębate albo wycina w niej takie otwory</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>Odbicie modelu</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Powtarza wszystko narysowane po jednej stronie także po drugiej</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Symetria obrotowa</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Obrotowa</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Powtarza wszystko narysowane raz dookoła osi</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>Szyk</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Szyk</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>Powtarza płytki wzdłuż linii w przestrzeni</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>Plastry siatki</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Plastry</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Tnie siatkę, po której się rysuje, na płytki oddające jej kształt</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>Nadaj symetrię teraz</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symetrycznie</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>Odbija raz jedną stronę na drugą</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>Wyłącz lub włącz</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Włączona</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>Wyłącza zaznaczoną operację albo włącza ją ponownie</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>Wcześniej w kolejności</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Wcześniej</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>Wykonuje zaznaczoną operację przed tą, która jest nad nią</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>Później w kolejności</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Później</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>Wykonuje zaznaczoną operację po tej, która jest pod nią</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>Utrwal jako płytki</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Utrwal</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Zamienia to, co tworzy zaznaczona operacja, w narysowane płytki</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>Nie ma siatki do pocięcia: najpierw ją dodaj</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>Jest już pierwsza</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>Jest już ostatnia</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Przyciąganie</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Przyciąganie</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>Przyciąga do punktów, linii pomocniczych i kratki</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Pióro</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Pióro</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Rysowanie kliknięciami zamiast jednym pociągnięciem: stawiaj punkty, przeciągaj, aby wygiąć</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>Nie wpisano liczby</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Usuń otwory</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Bez otworów</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Zamyka wszystkie otwory zaznaczonych płytek</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Dodaj punkt</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Dodaj punkt</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Dodaje punkt kontrolny pod kursorem albo obok zaznaczonego</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Usuń punkt</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Usuń punkt</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>Usuwa zaznaczone punkty kontrolne</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Gładki punkt</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gładki</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>Wygładza kontur w zaznaczonych punktach</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>Symetryczny punkt</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>Wygładza kontur, z uchwytami równej długości po obu stronach</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Narożnik</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Narożnik</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Zmienia zaznaczone punkty w narożniki</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>Nie zaznaczono żadnego punktu konturu</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Zaznacz jedną płytkę, której kontur da się edytować</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>Zaznaczenie nie ma otworów</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Przesuń i obróć</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Przesuń</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Przesuwa, obraca i skaluje uchwytami albo według liczb</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>Wzdłuż osi świata</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Osie świata</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Przesuwa wzdłuż osi świata, nie w płaszczyźnie płytki</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Przesuwaj dołączone płytki</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Dołączone</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Płytki narysowane na tej przesuwają się razem z nią</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Umieść na innej płytce…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Umieść na</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Kliknij płytkę, na której ma być umieszczona zaznaczona</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Uwolnij od płytki nadrzędnej</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Uwolnij</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Odłącza od płytki nadrzędnej: nie przesuwa się już z nią i nie zachowuje kąta do niej</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Ustaw prostopadle</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Prostopadle</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>Ustawia płytkę prostopadle do tej, na której jest umieszczona</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>Wyrównaj do najbliższej osi</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Wyrównaj</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>Obraca płytkę tak, aby była zwrócona wzdłuż osi świata</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>Zablokuj</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Zablokuj</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>Chroni zaznaczone płytki przed zmianami</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>Edytuj źródło</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Źródło</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>Zaznacza płytkę, z której powstała zaznaczona</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>Odłącz tę płytkę</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Odłącz</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>Zamienia zaznaczoną płytkę w narysowaną; pozostałe nadal tworzy operacja</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>Pomiń tę płytkę</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Pomiń</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>Pomija zaznaczoną płytkę; pozostałe nadal tworzy operacja</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>Zaznaczenie nie jest umieszczone na innej płytce</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>Zaznaczenie tworzy operacja</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>Zaznaczenie nie jest symetryczne</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>Zaznaczenie jest narysowane, nie utworzone przez operację</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Zaznacz wszystko</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Zaznacz wszystko</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Zaznacza wszystkie płytki</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Zaznacz następną</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Następna</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>Zaznacza następną płytkę</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Zaznacz poprzednią</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Poprzednia</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>Zaznacza poprzednią płytkę</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>Zaznacz połączone</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Połączone</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Zaznacza wszystkie płytki połączone z zaznaczonymi</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>Zaznacz równoległe</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Równoległe</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Zaznacza wszystkie płytki równoległe do zaznaczonych</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Zaznacz ten sam materiał</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Ten materiał</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Zaznacza wszystkie płytki z tego samego materiału co zaznaczone</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Zaczyna nowy model</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Cofa ostatni krok</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>Ponawia cofnięty krok</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>Usuwa zaznaczone płytki</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Postaw punkt</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nie ma czego cofnąć</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Cofnij „%1”</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nie ma czego ponowić</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Ponów „%1”</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Odepnij wszystkie części</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Odepnij wszystkie</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Wszystkie części można znowu przesuwać przy rozkładaniu na arkuszach</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>Żadna część nie jest przypięta do arkusza</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>Poszycie</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Poszycie</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>Pokazuje kształt, który zarysowują płytki, jako powierzchnię na nich</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Symetria lokalna</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symetria</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Odbija kontur względem szczeliny, gdy jest rysowany po jednej jej stronie</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Zetnij równo z podłożem</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Podłoże</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Odcina to, co narysowano poniżej podłoża</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>Na podłożu</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Na podłożu</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Rysuje płytkę leżącą na podłożu</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>Na płaszczyźnie przedniej</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>Od przodu</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Rysuje płytkę stojącą pośrodku, widzianą od przodu</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>Na płaszczyźnie bocznej</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Od boku</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Rysuje płytkę stojącą pośrodku, widzianą od boku</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>Równolegle do płytki</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Rysuje płytkę równoległą do zaznaczonej</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Przerysuj kontur</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Przerysuj</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Rysuje nowy kontur zaznaczonej płytki</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>Narysuj otwór</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Otwór</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>Rysuje otwór w zaznaczonej płytce</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Postaw na podłożu</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Postaw</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Stawia model na podłożu</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>Model już stoi na podłożu</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Udostępnij do dopasowania</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Udostępnij</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Kto otworzy zapisany model, zobaczy widok, pokazane wartości i eksport, i nic więcej</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Edytuj projekt</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Inni nie mogą jeszcze zmienić żadnej wartości</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Przód</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Przód</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Widok z przodu</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Góra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Góra</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Widok z góry</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Prawo</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Prawo</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Widok z prawej</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Tył</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tył</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Widok z tyłu</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Dół</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dół</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Widok z dołu</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Lewo</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Lewo</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Widok z lewej</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Następny narożnik</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Widok z następnego narożnika</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Patrz wprost na płytkę</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Na wprost</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Ustawia widok wprost na zaznaczoną płytkę</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Cały model w oknie</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Całość</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Pokazuje cały model</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Zaznaczenie w oknie</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Zaznaczenie w oknie</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>Pokazuje zaznaczone płytki w największym powiększeniu</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Poprzedni widok</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Wraca do poprzedniego widoku</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspektywa</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektywa</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>Pokazuje to, co dalej, mniejsze, tak jak widzi oko</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Rentgen</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rentgen</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Prześwietla wszystkie płytki aż po ich szczeliny</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Tylko zaznaczenie</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Izoluj</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Przygasza wszystkie inne płytki</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ukryj</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ukryj</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>Ukrywa zaznaczone płytki</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Pokaż ukryte</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Pokaż ukryte</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>Pokazuje znowu ukryte płytki</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Rozetnij widok</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Rozetnij</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Rozcina model płaszczyzną, aby zajrzeć do środka</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>Podłoże i cień</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>Pokazuje podłoże z kratką i cień modelu</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Linie naprężeń</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Naprężenia</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Pokazuje, gdzie model jest najbardziej obciążony</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>Żadna płytka nie jest ukryta</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>Nie ma poprzedniego widoku</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>Proste okno obywa się bez tego; pełne jest w Ustawieniach</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Pierwszy model w 3 minuty</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Przewodnik</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Krok po kroku narysuj, sprawdź i wytnij model, w pustym oknie</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Pomoc o tym, co jest pod kursorem</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Otwiera pomoc tam, gdzie mówi o tej części okna</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>Nie odbijaj</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Zostaw wszystko tak, jak było</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Wypisuje JSON, dla innych programów.</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Płytki, połączenia, rozmiar i masa modelu</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Czy trzyma się razem, stoi, da się złożyć i mieści się na arkuszu</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Czy jest dość mocne: siły, naprężenia i ile utrzyma</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>Części do wycięcia, we współrzędnych każdej płytki</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Obraz modelu; wymaga ekranu</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Jak się to składa, krok po kroku; wymaga ekranu</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>Nazwane wartości modelu i co z nich powstaje</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Plik do cięcia i ocena dla każdego wiersza tabeli wartości</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Wszystkie rodzaje operacji albo operacje modelu</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>Pętle, w których płaszczyzna przecina siatkę</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Płytki, które oddają siatkę, stoją i dają się złożyć</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Model z siatki w plastrach</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Model z płaskich arkuszy z wczepami na krawędziach</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Części gęsto ułożone na arkuszach albo elementy paska (.json)</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Odtwarza skrypt tego, co ktoś robi w oknie</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Szczeliny nic z nich nie zostawiają, więc nie ma części: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>Za duże na arkusz, na osobnych arkuszach: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Za wąskie, aby zmieścić numer: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Otwór lub wcięcie węższe niż rzaz nie zostanie wycięte: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>Brak miejsca na numery wszystkich połączeń: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>Nie udało się zapisać na standardowe wyjście.</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>Nie ma czego sprawdzać: model nie ma płytek.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>Płytki uginają się tam, gdzie połączenia dzielą się obciążeniem (elementy skończone); trwa kilka sekund.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>Obciążenie trwa miesiącami: każdy materiał zachowuje wtedy tylko swoją część wytrzymałości.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>Nie ma „%1”.</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF z warstwami według przeznaczenia</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Wersja pliku DXF: r2000 lub r12 (r2000).</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>sam model</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Milimetry na jednostkę pliku FlatFab (25.4).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-code do laserów</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>projekt LightBurn</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>bryły na swoich miejscach</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>lista części</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF w naturalnej wielkości</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Strony pliku PDF: sheet albo kafelki na a4 lub letter (sheet).</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>obraz arkuszy</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Jak leżą części w pliku STL lub 3MF: in-place (na swoich miejscach) lub flat (płasko na arkuszach) (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>części do druku</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>pliki do cięcia, w naturalnej wielkości</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>wszystko do warsztatu</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>nie ma ekranu z OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>Wyszukiwanie przerwano przed końcem, bo komputer jest zajęty: inne uruchomienie może dać inny układ.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Szczeliny do wypróbowania</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Pasek do wciskania</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Listewka do zmierzenia</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Za blisko krawędzi: szczelina nic by nie trzymała</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Za blisko krawędzi: szczelina nic by nie trzymała. B: odsuń ją</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Odsunięto o %1 od krawędzi. B: cofnij</translation>
    </message>
    <message>
        <source>level</source>
        <translation>poziomo</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>pionowo</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>prostopadle do krawędzi</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>równolegle do poprzedniej</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Obracanie…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Narysuj obrys</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Jeszcze niepołączone</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>„%1” to %2, a to jest tu niemożliwe.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>„%1” i inne wyrażenie chcą tu naraz różnych wartości.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Nie ma już tego, do czego należy ta liczba.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
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
        <translation>Kąt</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>X środka</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>Y środka</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>Wysokość liter</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Rzaz</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Szerokość arkusza</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Wysokość arkusza</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Średnica narzędzia</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Fazka szczelin</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Garbki w szczelinach</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Zawartość</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Siła wzdłuż X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Siła wzdłuż Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Siła w poprzek</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Punkt styku</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>„%1” nie jest tu możliwe: liczby zależne od parametrów utrzymują %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>„%1” nie jest tu możliwe: %2 zależy od „%3” i pozostaje bez zmian.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>Nie można obliczyć „%1”.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>„%1” jest puste, a tu nie może być.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>za mało pamięci</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>siatka: to jest płaskie</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>bajty</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>wpisy</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>spis zawartości jest uszkodzony</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>ten wpis jest uszkodzony</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>ten wpis jest zaszyfrowany</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>w tym pliku jest więcej niż jego zawartość</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>ten wpis występuje dwa razy</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>ten wpis jest spakowany w nieznany sposób</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>ten wpis ma inną nazwę niż w spisie zawartości</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>wpisy dzielą ze sobą bajty</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>ten wpis po rozpakowaniu jest o wiele za duży</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>nieuszkodzone dane gzip</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>reszta danych gzip</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>większy arkusz</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>plik musi mieć nazwę</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>ten plik jest tylko do odczytu</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>ten folder jest tylko do odczytu</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>to jest folder</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>ta wartość jest tu niedozwolona</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>nic nie znaleziono, oczekiwano: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>znaleziono: „%1”, oczekiwano: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>taka ilość jest niemożliwa</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>znaleziona liczba: %1, oczekiwana najwyżej: %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>%3: znaleziono %1, oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>utworzono w nowszym FlatFitFab</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>utworzono w nowszym FlatFitFab: znaleziono format %1, oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>te punkty kontrolne nie tworzą zamkniętego konturu</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>te punkty kontrolne nie tworzą zamkniętego konturu: znaleziono: %1, oczekiwano: %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>wokół tego obrysu nie da się poprowadzić ścieżki w odległości połowy rzazu na całej długości</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>wokół „%1” nie da się poprowadzić ścieżki w odległości połowy rzazu %2 mm na całej długości; wygładź najdrobniejsze szczegóły konturu albo podaj inny rzaz materiału</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>rzaz zamyka szczelinę</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 ma szczelinę szerokości %2 mm, którą zamknąłby rzaz %3 mm</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>plik %1</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>plik %1 z %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 lub %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>nie można otworzyć</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>nie można zapisać</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>to nie model, oczekiwano: %1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>plik tu się kończy, oczekiwano: %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>plik kończy się za wcześnie</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>znaleziono: „%1”, oczekiwano: liczba skończona</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>liczba nie jest skończona</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>te osie nie tworzą układu, oczekiwano: dwie o długości 1 pod kątem prostym</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>ten kontur nie obejmuje żadnego pola</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>nic nie ma numeru %1</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>to odwołuje się do czegoś, co nie istnieje</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>numeru %1 użyto dwa razy, oczekiwano: własny numer</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>tego numeru użyto dwa razy, oczekiwano: własny numer</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>te dwie płytki są prawie równoległe i nie można ich połączyć</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>ten kontur przecina sam siebie</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>otwór dotykałby krawędzi lub innego otworu</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>zostałoby za mało punktów, aby cokolwiek objąć</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>szczeliny nie zostawiają nic z żadnej płytki, więc nie ma czego ciąć</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>nie ma jeszcze żadnej płytki, więc nie ma czego ciąć</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>żadnego z miejsc między konturami nie da się pokryć (%1), więc nie ma poszycia</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>żadne kontury nie krzyżują się na krawędziach, więc nie ma poszycia</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>nie ma polecenia „%1”</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>nie ma takiego polecenia</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>to zdarzenie nie ma tu sensu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>ta wersja nie obsługuje „%1”</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>ta wersja tego nie obsługuje</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>nie udało się tego obliczyć</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>nie udało się wyciąć „%1”: nie da się obliczyć, co zostawiają szczeliny</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>nie udało się wyciąć płytki</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>nie udało się obliczyć bryły „%1”</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>nie udało się obliczyć bryły</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>nie udało się przyciąć znaków na „%1” przy krawędzi</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>nie udało się przyciąć znaków na płytce przy krawędzi</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>nie udało się obliczyć płytek operacji „%1”</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>nie udało się obliczyć płytek operacji</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>coś poszło nie tak wewnątrz FlatFitFab (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>coś poszło nie tak wewnątrz FlatFitFab</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>zostało zatrzymane</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>zawartość tego pliku jest uszkodzona</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1: lekkie przekoszenie wyprostowano</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>wyprostowano lekko przekoszoną płytkę</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>%1: kontur przecina sam siebie; zachowano jego największą pętlę</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>kontur przecina sam siebie; zachowano jego największą pętlę</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>%1: pominięto otwór, który wystaje poza kontur</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>pominięto otwór, który wystaje poza kontur</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>%1: pominięto otwór, który nie ma pola</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>pominięto otwór, który nie ma pola</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>%1: zachodzące na siebie otwory złączono w jeden</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>zachodzące na siebie otwory złączono w jeden</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>%1: otwór, który wystaje poza kontur, wycięto z konturu</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>otwór, który wystaje poza kontur, wycięto z konturu</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>pominięto wiersze po ostatniej płytce</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>pominięto tekst po ostatniej płytce, wiersze: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1: nie udało się odczytać, pominięto</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>pominięto obraz lub siatkę</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1: pominięto, %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>nie udało się odczytać tego, co pokazuje %1; jego miejsce zachowano</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>nie udało się odczytać podkładu; jego miejsce zachowano</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved lub scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>trzy punkty kontrolne na odcinek i jeszcze jeden</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>co najmniej jedna linia</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>dwa różne miejsca</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>słowo z liter i cyfr, jeden raz</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>brakuje jego danych</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>SHA-256 z 64 cyfr szesnastkowych</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>wpis o tej nazwie nie należy do tego pliku</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>dane tego wpisu nie zgadzają się z jego nazwą, SHA-256</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>brakuje tego wpisu</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>nic w dokumencie nie odwołuje się do tego wpisu</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point, patch lub edge</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point, patch, edge lub hanging</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>szerokość od 1 do 10000 mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>siła [x, y, z] większa od 0, najwyżej 1000000 N</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>wysokość od 0 do 10000 mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>część swojej masy</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden lub detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>coś innego niż utworzone, każde wystąpienie raz</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>identyfikator mniejszy niż nextId</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>udział większy od 0, najwyżej 1</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>więcej niż minus grubość</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>szerokość i wysokość większe od 0</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone lub tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>trzy punkty kontrolne na odcinek, co najmniej 6</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom lub top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>kierunek o długości 1</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs lub none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>udział od 0.05 do 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>coś wymaganego od dwóch płytek, pary rosnąco</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>płytka nadrzędna, która nie pochodzi od swojej podrzędnej</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>co najmniej jeden materiał</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>każda część raz, w kolejności płytek</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>każda płytka raz, w ich kolejności</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none, half, quarter lub free</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh, picture lub curves</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>nic: dociąga się tylko siatki</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>promień od 0.1 do 1000 mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>ścieżka pliku</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>SHA-256 bloba albo plik</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>nic: siatka nie leży na żadnej płytce</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>skala od 1e-9 do 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>krycie od 0 do 1</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals lub groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>wyrażenie, które nie jest tak długie</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice lub switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>nazwa bez „=”, każda raz</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>każda wartość raz</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>słowo z liter i cyfr, każde raz</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>każda liczba raz</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>długość najwyżej 1000000 mm</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>ostatni punkt kontrolny równy pierwszemu</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>liczba</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>ilość</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>punkt z dwóch liczb</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>trzy punkty kontrolne na odcinek i znowu pierwszy, co najmniej 7</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>co najmniej 1 krzywa</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>bufor z bajtami</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>bufor w pliku</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>długość, którą ma jego bufor</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>typ liczb znany w glTF</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>tyle wartości, ile ma jego bufor</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>tyle liczb, ile trzeba</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>węzeł, który nie zawiera się sam w sobie</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>blok pliku GLB</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>wersja 2 GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>plik glTF</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>wersja 2 glTF</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>obiekt</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true lub false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>lista</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>liczba większa od 0, najwyżej 1000000</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>liczba od 0 do 1000000</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>liczba całkowita w swoim zakresie</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>tekst</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>punkt [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>punkt [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>lista punktów</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>nazwa w cudzysłowie albo koniec obiektu</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>dwukropek</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>przecinek albo koniec listy</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>sekwencja specjalna JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>tekst w UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>koniec tekstu w cudzysłowie</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>kolejna wartość po przecinku</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>nie więcej niż 1024 poziomy</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>mniejszy plik</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>koniec pliku</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>wartość</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>każdy klucz obiektu tylko raz</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>obie połówki znaku</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>kolor taki jak #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>grubość linii w mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>prędkość w mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>wiersz G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>wiersze G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>największe S</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>szerokość i wysokość w mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>udział od 0 do 1</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>szerokość mostków w mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>długość najazdów w mm</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>maszyny</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>maszyna</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>trójkąty</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>wierzchołki</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>jest w innym folderze</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>siatka</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>liczba całkowita</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>co najmniej trzy punkty</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon lub polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>co najmniej jeden kąt</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>zadanie rozkładania na pasku</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>co najmniej jeden element</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>co najmniej trzy narożniki ściany</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>liczba wierzchołków</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>liczba ścian</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>narożniki ściany</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>piksele</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>obraz jest uszkodzony</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>reszta obrazu</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>obraz jest tu uszkodzony</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>obraz PNG, JPEG lub WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>obraz z co najmniej jednym pikselem</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>nic nie zapisuje do tego potoku</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>przez 10 sekund nic z tego nie wyszło</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>nic nie czyta z tego potoku</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>format</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element lub end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii lub binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>typ taki jak float lub int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>najpierw element</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>tyle wartości, ile podaje plik</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y i z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>długość listy</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>dysk jest pełny</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>liczba trójkątów</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>tyle trójkątów, ile podaje plik</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet lub endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex lub endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>trzy narożniki trójkąta</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>linie; tekst trzeba najpierw zamienić na ścieżki</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>linie; obraz trzeba najpierw odrysować</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>linie, figury lub ścieżki</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>przekształcenie</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>grupy w grupach</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>miejsca w obrębie kilometra</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>pary liczb</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>dane ścieżki</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>elementy i atrybuty</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>rysunek SVG</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>długość</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punkty</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>obraz lub rysunek</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>w tym pliku nie ma modelu 3D</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>model 3D</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>jednostka taka jak millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>dwanaście liczb</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>obiekt, który nie zawiera sam siebie</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>Wyprostowano %n lekko przekoszoną płytkę.</numerusform>
            <numerusform>Wyprostowano %n lekko przekoszone płytki.</numerusform>
            <numerusform>Wyprostowano %n lekko przekoszonych płytek.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n kontur przecinał sam siebie; zachowano jego największą pętlę.</numerusform>
            <numerusform>%n kontury przecinały same siebie; z każdego zachowano największą pętlę.</numerusform>
            <numerusform>%n konturów przecinało same siebie; z każdego zachowano największą pętlę.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>Pominięto %n otwór, który wystawał poza kontur.</numerusform>
            <numerusform>Pominięto %n otwory, które wystawały poza kontur.</numerusform>
            <numerusform>Pominięto %n otworów, które wystawały poza kontur.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>Pominięto %n otwór, który nie miał pola.</numerusform>
            <numerusform>Pominięto %n otwory, które nie miały pola.</numerusform>
            <numerusform>Pominięto %n otworów, które nie miały pola.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Złączono zachodzące na siebie otwory %n płytki.</numerusform>
            <numerusform>Złączono zachodzące na siebie otwory %n płytek.</numerusform>
            <numerusform>Złączono zachodzące na siebie otwory %n płytek.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n otwór, który wystawał poza kontur, wycięto z konturu.</numerusform>
            <numerusform>%n otwory, które wystawały poza kontur, wycięto z konturu.</numerusform>
            <numerusform>%n otworów, które wystawały poza kontur, wycięto z konturu.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Pominięto tekst po ostatniej płytce w %n miejscu.</numerusform>
            <numerusform>Pominięto tekst po ostatniej płytce w %n miejscach.</numerusform>
            <numerusform>Pominięto tekst po ostatniej płytce w %n miejscach.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>Pominięto %n obraz lub siatkę, bo odczyt się nie udał.</numerusform>
            <numerusform>Pominięto %n obrazy lub siatki, bo odczyt się nie udał.</numerusform>
            <numerusform>Pominięto %n obrazów lub siatek, bo odczyt się nie udał.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>Nie udało się odczytać %n podkładu; jego miejsce zachowano.</numerusform>
            <numerusform>Nie udało się odczytać %n podkładów; ich miejsca zachowano.</numerusform>
            <numerusform>Nie udało się odczytać %n podkładów; ich miejsca zachowano.</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>nie można użyć tego folderu</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>jest otwarte w innym oknie</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>miejsca, w których linia może przecinać samą siebie</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>jego dane są uszkodzone</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>siatka z co najmniej jednym trójkątem</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>krawędź z trzema ścianami lub więcej</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>siatka, w której przy krawędzi spotykają się dwie ściany</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>to, co miało zależeć od „%1”, jest teraz zwykłą liczbą</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n liczba nie zależy już od tego, co dla niej wpisano.</numerusform>
            <numerusform>%n liczby nie zależą już od tego, co dla nich wpisano.</numerusform>
            <numerusform>%n liczb nie zależy już od tego, co dla nich wpisano.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>obraz</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>rysunek</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>każdą maszynę raz, w ich kolejności</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>resztek</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>obrys od 0, 0, który się nie przecina</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>grubości</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>to, co arkusz może mieć</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materiałów</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>obrys jest otwarty: jego końce są oddalone o %1 mm</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>współrzędne do 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>umieszczonych obiektów</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>Koło</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Średnica</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipsa</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Prostokąt</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Promień rogów</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Wielokąt</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Boki</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Gwiazda</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Średnica wewnętrzna</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Ramiona</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Fasolka</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>Nie da się wykonać</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF, naturalna wielkość</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, po jednym na arkusz</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF dla starych programów, R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>Modele FlatFitFab</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code do laserów GRBL</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code, po jednym na arkusz</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>Siatki glTF</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>Projekt LightBurn</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, po jednym na arkusz</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>Siatki OBJ</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, bryły na swoich miejscach</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, poszycie jako siatka</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>Siatki OFF</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Lista części do arkusza kalkulacyjnego</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, strona na arkusz</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, w kafelkach na A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, w kafelkach na Letter</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>Siatki PLY</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Obraz arkuszy</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Obrazy, po jednym na arkusz</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>Siatki STL</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, bryły na swoich miejscach</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, poszycie jako siatka</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, bryły leżące płasko</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG, naturalna wielkość</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, po jednym na arkusz</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>Siatki 3MF</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, bryły na swoich miejscach</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, bryły leżące płasko</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Wszystko do warsztatu, spakowane</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Wszystko do warsztatu, w folderze</translation>
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
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; to cofa.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>Nic nie przesunięto: tam, gdzie spotykają się „%1” i „%2”, nie ma dwóch szczelin dzielących głębokość.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>Nic nie zmieniono: %1 i %2 nie dają się tak połączyć.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>Nic nie odwrócono: szczeliny „%1” i „%2” nie mogą otwierać się w drugą stronę.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>Nic nie przycięto: „%1” nie tkwi w „%2” albo nic by nie zostało.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Ruszaj myszą, aby przesuwać rozcięcie, puść, aby je tam zostawić. &lt;kbd&gt;Esc&lt;/kbd&gt; cofa.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>Nie da się rysować na płaszczyźnie widzianej od krawędzi: obróć widok, aby rysować dalej.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Ścieżkę odrzucono: jej płytki już nie ma.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>Nic nie narysowano: z tej linii nie powstanie płytka. Narysuj ją jako jedną otwartą pętlę.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>Nic nie narysowano: wszystko leży poniżej podłoża, gdzie jest odcinane.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>Nie zrobiono otworu: musi leżeć wewnątrz „%1” i zostawić płytkę w jednym kawałku.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>Otwór wystaje poza krawędź „%1” i został z niej wycięty.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>Otwór dotykał innych w „%1”; teraz to jeden otwór.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>%1: pominięto otwory poza nowym konturem.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj płytkę na podłożu jednym pociągnięciem. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj płytkę na płaszczyźnie przedniej jednym pociągnięciem. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj płytkę na płaszczyźnie bocznej jednym pociągnięciem. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj jednym pociągnięciem płytkę równoległą do „%1”. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Narysuj jednym pociągnięciem nowy kontur „%1”. &lt;kbd&gt;Esc&lt;/kbd&gt; zostawia stary.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj jednym pociągnięciem otwór w „%1”. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj otwór: zacznij na płytce, która ma go dostać. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>Nic nie zaimportowano: żadna linia w %1 nie tworzy zamkniętego obrysu. Można je grawerować.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n obrys z „%1” nie pasował i został pominięty.</numerusform>
            <numerusform>%n obrysy z „%1” nie pasowały i zostały pominięte.</numerusform>
            <numerusform>%n obrysów z „%1” nie pasowało i zostało pominiętych.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: pominięto %2; %3.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: pominięto %2 i %3; %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n tekst</numerusform>
            <numerusform>%n teksty</numerusform>
            <numerusform>%n tekstów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n obraz</numerusform>
            <numerusform>%n obrazy</numerusform>
            <numerusform>%n obrazów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>wczytano %n linię</numerusform>
            <numerusform>wczytano %n linie</numerusform>
            <numerusform>wczytano %n linii</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 leży ukośnie do „%1”: najpierw przenieś podkład na płaszczyznę „%1”.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 ma %n obrys, a to za dużo: odrysuj zgrubnie albo najpierw wygładź.</numerusform>
            <numerusform>%1 ma %n obrysy, a to za dużo: odrysuj zgrubnie albo najpierw wygładź.</numerusform>
            <numerusform>%1 ma %n obrysów, a to za dużo: odrysuj zgrubnie albo najpierw wygładź.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nic nie odrysowano: żaden fragment „%1” nie leży po tej stronie progu.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: przeciągnij od środka na zewnątrz; kliknięcie robi figurę zwykłej wielkości.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: przeciągnij od środka na zewnątrz, aby wyciąć otwór w „%2”.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby ustalić ten rozmiar; &lt;kbd&gt;Shift&lt;/kbd&gt; zachowuje równe boki. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Narysuj pierwszą płytkę: naciśnij, narysuj kształt jednym pociągnięciem, puść.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Przeciągnij, aby obrócić widok; z &lt;kbd&gt;Shift&lt;/kbd&gt; zaznacza się grupę.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Przeciągnij poza „%1”, aby narysować płytkę w poprzek; kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Kliknij, aby zaznaczyć „%1”. Przeciągnij, aby obrócić widok: nie da się rysować na płytce widzianej od krawędzi.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Przeciągnij, aby przesuwać rozcięcie przez model; &lt;kbd&gt;Esc&lt;/kbd&gt; je zamyka.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Kliknij, aby zaznaczyć problem %1.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Przeciągnij, aby przesunąć punkt; &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożnik, strzałki przesuwają o 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Przeciągnij, aby wygiąć krzywą; &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożnik, &lt;kbd&gt;Shift&lt;/kbd&gt; zachowuje kierunek.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Kliknij dwa razy, aby dodać tu punkt; przeciągnij, aby wygiąć kontur.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Kliknij, aby zaznaczyć połączenie „%1” i „%2”.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Przeciągnij, aby pogłębić szczelinę „%1” i spłycić szczelinę „%2”; kliknij, aby zaznaczyć połączenie.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Przeciągnij, aby pogłębić szczelinę „%1” i spłycić szczelinę „%2”; strzałki przesuwają o 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Przeciągnij, aby przesunąć ciężar %1 na „%2”; kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Strzałki przesuwają ciężar %1 na „%2” o 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; i &lt;kbd&gt;−&lt;/kbd&gt; go zmieniają, &lt;kbd&gt;Del&lt;/kbd&gt; usuwa.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Przeciągnij, aby przesunąć nacisk %1 na „%2”, a za czubek, aby go obrócić; kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Strzałki przesuwają nacisk %1 na „%2” o 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; i &lt;kbd&gt;−&lt;/kbd&gt; go zmieniają, &lt;kbd&gt;Del&lt;/kbd&gt; usuwa.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>„%1” tworzy operacja „%2”: kliknij, aby edytować wszystkie, kliknij ponownie, aby tylko tę.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Kliknij, aby zaznaczyć tylko „%1”; przeciągnij na zewnątrz, aby narysować płytkę w poprzek.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Przeciągnij okrągły uchwyt, aby przesunąć początek lub koniec „%1”; kliknij jedną płytkę, aby ją zaznaczyć.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Przeciągnij, aby przesunąć początek „%1”; kliknij, aby go wpisać.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Przeciągnij, aby przesunąć koniec „%1”; kliknij, aby go wpisać.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Kliknij, aby zobaczyć widok z przodu; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Kliknij, aby zobaczyć widok z tyłu; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Kliknij, aby zobaczyć widok z lewej; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Kliknij, aby zobaczyć widok z prawej; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Kliknij, aby zobaczyć widok z góry; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Kliknij, aby zobaczyć widok z dołu; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Kliknij, aby patrzeć na tę krawędź; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Kliknij, aby patrzeć na ten narożnik; przeciągnij, aby obrócić widok.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Przeciągnij, aby obrócić widok; kółko przybliża i oddala.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby tu zostawić: szczelina „%1” zajmuje %2%. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Kliknij miejsce na płytce, aby położyć tam: %1. &lt;kbd&gt;Esc&lt;/kbd&gt; kończy.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Naciśnij na płytce i przeciągnij w kierunku nacisku. &lt;kbd&gt;Esc&lt;/kbd&gt; kończy.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Naciśnij na płytce i przeciągnij, aby ją pociągnąć i zobaczyć, co się stanie; nic nie zostaje.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Puść, aby uwolnić: nic nie zostaje.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Przeciągnij, aby przesunąć. &lt;b&gt;Kliknięcie&lt;/b&gt; zaznacza.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>Przeciągnij czubek, aby obrócić nacisk; dłuższa strzałka naciska mocniej.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Puść, aby położyć tu ciężar. &lt;kbd&gt;Esc&lt;/kbd&gt; odstawia na miejsce.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Puść, aby tu naciskać. &lt;kbd&gt;Esc&lt;/kbd&gt; odstawia na miejsce.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>Nie dodano ciężaru: kliknij płytkę.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>Nie dodano nacisku: naciśnij na płytce.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kopia „%1” też to dźwiga; w panelu &lt;i&gt;Właściwości&lt;/i&gt; można to ograniczyć do tej płytki.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>%n kopia „%1” też to dźwiga; w panelu &lt;i&gt;Właściwości&lt;/i&gt; można to ograniczyć do tej płytki.</numerusform>
            <numerusform>%n kopie „%1” też to dźwigają; w panelu &lt;i&gt;Właściwości&lt;/i&gt; można to ograniczyć do tej płytki.</numerusform>
            <numerusform>%n kopii „%1” też to dźwiga; w panelu &lt;i&gt;Właściwości&lt;/i&gt; można to ograniczyć do tej płytki.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ciężar zostaje na miejscu: tam byłby poza „%1”.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Nacisk zostaje na miejscu: tam byłby poza „%1”.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Przeciągnij, aby ustawić, z jak daleka „%1” dociąga podkłady.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Puść: „%1” będzie dociągać podkłady z odległości do %2. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rysuj na płytce, którą chcesz grawerować, albo ją kliknij. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Przeciągnij, aby narysować linię na „%1”; &lt;kbd&gt;Shift&lt;/kbd&gt; trzyma ją prosto. Kliknij, aby wstawić tekst.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby zachować linię. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>„%1” graweruje się od przodu, bo tylko do tej strony dociera laser; widok się do niej obrócił.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>Nic nie wygrawerowano: to nie leży na „%1”.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>Znaku „%1” nie da się grawerować.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Przeciągnij z jednego miejsca do drugiego, aby zmierzyć; &lt;kbd&gt;Ctrl&lt;/kbd&gt; wyłącza przyciąganie. &lt;kbd&gt;Esc&lt;/kbd&gt; kończy.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Przejdź do drugiego miejsca. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Kliknij lub przeciągnij, aby zmierzyć ponownie. &lt;kbd&gt;Esc&lt;/kbd&gt; usuwa pomiar.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Przeciągnij wzdłuż czegoś, czego długość znasz; dopasuje się cały model. &lt;kbd&gt;Esc&lt;/kbd&gt; kończy.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Wpisz żądaną długość; &lt;kbd&gt;Enter&lt;/kbd&gt; skaluje cały model. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>Model nie może być aż tak duży lub mały.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>Modelu nie da się aż tak przeskalować: %1 przekroczy granice.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Kliknij płytkę, względem której odbić; przeciągnij, aby obrócić widok. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: zmień w koło</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: zmień w elipsę</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: wyprostuj linie</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: wyprostuj narożniki</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: odsuń szczelinę od krawędzi</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>Teraz to koło.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>Teraz to elipsa.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Wyprostowano linie.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Wyprostowano narożniki.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Odsunięto od krawędzi.</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>„%1” zostaje tam, gdzie narysowano: po odsunięciu szczelina pocięłaby „%2”. Rysuj w poprzek krawędzi, nie wzdłuż niej.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Puść, aby zacząć „%1” tutaj: %2%. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Puść, aby zakończyć „%1” tutaj: %2%. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Przeciągnij z płytki na zewnątrz, aby rysować w poprzek piórem; przeciągnij tutaj, aby obrócić widok. &lt;kbd&gt;Esc&lt;/kbd&gt; odkłada pióro.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Przeciągnij poza „%1”, aby rysować w poprzek piórem; kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Kliknij, aby postawić pierwszy punkt, przeciągnij, aby wygiąć. &lt;kbd&gt;Esc&lt;/kbd&gt; odkłada pióro.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Kliknij, aby postawić punkt, przeciągnij, aby wygiąć; &lt;kbd&gt;Enter&lt;/kbd&gt; zamyka, &lt;kbd&gt;Backspace&lt;/kbd&gt; cofa punkt.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Kliknij, aby postawić punkt, przeciągnij, aby wygiąć; &lt;kbd&gt;Enter&lt;/kbd&gt; zamyka, &lt;kbd&gt;Backspace&lt;/kbd&gt; cofa punkt. Kliknięcie z &lt;kbd&gt;Ctrl&lt;/kbd&gt; nie przyciąga.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>Kontur przecina sam siebie: &lt;kbd&gt;Enter&lt;/kbd&gt; zachowuje największą pętlę, &lt;kbd&gt;Backspace&lt;/kbd&gt; cofa punkt.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Przeciągnij, aby wygiąć; &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożnik, &lt;kbd&gt;Shift&lt;/kbd&gt; trzyma kierunek.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Przeciągnij, aby przesunąć punkt; &lt;kbd&gt;Ctrl&lt;/kbd&gt; wyłącza przyciąganie, &lt;kbd&gt;Shift&lt;/kbd&gt; trzyma kierunek.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Przeciągnij uchwyt, aby wygiąć; &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożnik.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Kliknij, aby zamknąć kontur; przeciągnij, aby przesunąć punkt.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; stawia punkt, &lt;kbd&gt;Tab&lt;/kbd&gt; przechodzi do następnej liczby. &lt;kbd&gt;Esc&lt;/kbd&gt; zamyka pasek.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Nie zamknięto: punkty niczego jeszcze nie obejmują.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Kontur jest jeszcze otwarty: &lt;kbd&gt;Enter&lt;/kbd&gt; go zamyka, &lt;kbd&gt;Esc&lt;/kbd&gt; cofa.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Na razie: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Na razie: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; wykonuje.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; wykonuje. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Puść, aby tu zostawić. &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożnik, &lt;kbd&gt;Shift&lt;/kbd&gt; zachowuje kierunek.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Puść, aby tak zostawić. &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożnik, &lt;kbd&gt;Shift&lt;/kbd&gt; zachowuje kierunek.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby tak zostawić. &lt;kbd&gt;Ctrl&lt;/kbd&gt; robi narożniki na końcach. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>Tutaj kontur przecinałby sam siebie; zostaje taki, jak przed chwilą.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Tutaj otwór dotykałby krawędzi lub innego otworu; zostaje taki, jak przed chwilą.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>Tutaj „%1” trzeba by w całości ściąć przy podłożu; zostaje, jak było.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>Nic nie usunięto: kontur wymaga co najmniej dwóch punktów.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby zaznaczyć wszystko, co w całości jest w środku. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby zaznaczyć punkty w środku. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 zachowuje kąt do „%2”. Uwolnij tę płytkę, aby obracać ją dowolnie.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 nie jest na innej płytce, więc nie ma do niej kąta.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>„%1” nie może być na „%2”, bo „%2” jest już na „%1”.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 i %2 się nie spotykają: najpierw przesuń jedną tak, aby przecinała drugą.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Kliknij płytkę, na której umieścić „%1”. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Przeciągnij, aby obrócić widok; &lt;kbd&gt;Spacja&lt;/kbd&gt; odtwarza, &lt;kbd&gt;←&lt;/kbd&gt; i &lt;kbd&gt;→&lt;/kbd&gt; przechodzą krok po kroku. &lt;kbd&gt;Esc&lt;/kbd&gt; zamyka kroki.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>Model się zmienił, więc widok jego kroków zamknięto.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Przeciągaj dalej poza „%1”; szczelina kończy się na krawędzi. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Przeciągaj dalej poza „%1”. &lt;kbd&gt;Ctrl&lt;/kbd&gt; zostawia szczelinę tak, jak ją rysujesz. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>Widok się obraca: rysuj od razu dalej albo poczekaj, aż się zatrzyma.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Narysuj obrys: wyjdź z szarej strefy tam, gdzie ma się zaczynać. Puść tutaj, aby anulować.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Narysuj kontur i puść, aby go zamknąć. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby utworzyć płytkę. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby wyciąć otwór w „%1”. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby nadać „%1” ten kontur. &lt;kbd&gt;Esc&lt;/kbd&gt; zostawia stary.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby utworzyć płytkę odbitą względem szczeliny. Przytrzymaj &lt;kbd&gt;Shift&lt;/kbd&gt;, aby zostawić tylko tę stronę. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby utworzyć odbitą płytkę. Zwolnij &lt;kbd&gt;Shift&lt;/kbd&gt;, aby zostawić tylko tę stronę. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby nadać „%1” ten kontur odbity względem szczeliny. &lt;kbd&gt;Shift&lt;/kbd&gt; działa odwrotnie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Puść&lt;/b&gt;, aby utworzyć płytkę odbitą względem pionu. Przytrzymaj &lt;kbd&gt;Shift&lt;/kbd&gt;, aby zostawić tylko tę stronę.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Prowadź linię wzdłuż turkusowej krzywej, aby przyciągała się do „%1”; przytrzymaj &lt;kbd&gt;Ctrl&lt;/kbd&gt;, aby się od niej oderwać. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; bierze ją całą.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Shift+Enter: weź całą prowadnicę</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>Szczelina nie dotyka prowadnicy, więc żadnej nie można wziąć w całości.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>Nic nie narysowano: szczelina nie wyszła poza „%1”. Zacznij w środku i przeciągnij przez krawędź; &lt;kbd&gt;O&lt;/kbd&gt; rysuje otwory, &lt;kbd&gt;E&lt;/kbd&gt; graweruje.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>Nic nie narysowano: linia jest za krótka, aby cokolwiek objąć.</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Nic nie narysowano: linia krótsza niż %1 uchodzi za drgnięcie ręki, chyba że zamyka pętlę.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>Nic nie narysowano: linia biegnie tam i z powrotem i niczego nie obejmuje.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>Nic nie narysowano: linia przecina samą siebie, a żadna jej pętla nie jest dość duża.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1: nie odbito, bo obie połowy by się nie spotkały.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>Kontur przecina sam siebie; zachowano największą pętlę.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1: odbito; pominięto to, co przeszło przez oś i wróciło.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 nie sięga swojej szczeliny: nic nie łączy tej płytki z „%2”.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1: narysowano obok szczeliny, więc dodano szyjkę i ścięto płytkę równo z podłożem.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1: narysowano obok szczeliny, więc dodano szyjkę, która w nią wchodzi.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1: płytka nie jest symetryczna, jej połowy się różnią.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Przeciągnij strzałkę, aby przesunąć „%1”, pierścień, aby obrócić, kostkę, aby przeskalować; albo wpisz liczby. &lt;kbd&gt;Esc&lt;/kbd&gt; ukrywa uchwyty.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Przeciągnij, aby przesunąć; &lt;kbd&gt;Shift&lt;/kbd&gt; trzyma jeden kierunek.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Przeciągnij, aby obrócić.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Przeciągnij, aby przeskalować.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby tak zostawić. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Podkład zablokowany: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nie da się aż tak przesunąć ani przeskalować „%1”.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Przeciągnij wzdłuż czegoś w „%1”, czego długość znasz; &lt;kbd&gt;Shift&lt;/kbd&gt; trzyma osiem kierunków. &lt;kbd&gt;Esc&lt;/kbd&gt; kończy.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Wpisz, jakie to długie; &lt;kbd&gt;Enter&lt;/kbd&gt; nada „%1” taki rozmiar. &lt;kbd&gt;Esc&lt;/kbd&gt; usuwa linię.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Żaden płaski kawałek „%1” nie jest dość duży na płytkę: najpierw powiększ podkład.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Płaskich kawałków jest więcej niż %1: wybierz mniej ścian.</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Arkusza grubości %1 nie da się zginać: wybierz materiał najwyżej %2.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Zegnij wzdłuż naciętych linii, potem połącz krawędzie o tym samym numerze: %n szew.</numerusform>
            <numerusform>Zegnij wzdłuż naciętych linii, potem połącz krawędzie o tym samym numerze: %n szwy.</numerusform>
            <numerusform>Zegnij wzdłuż naciętych linii, potem połącz krawędzie o tym samym numerze: %n szwów.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Kliknij płytkę, aby ją przesunąć lub obrócić, albo ją przeciągnij. &lt;kbd&gt;Esc&lt;/kbd&gt; ukrywa uchwyty.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Przeciągnij strzałkę, aby przesunąć, pierścień, aby obrócić, kostkę, aby przeskalować; albo wpisz liczby. &lt;kbd&gt;Esc&lt;/kbd&gt; ukrywa uchwyty.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Przeciągnij, aby przesunąć „%1”; kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Przeciągnij, aby przesunąć; &lt;kbd&gt;Ctrl&lt;/kbd&gt; zostawia kopię, &lt;kbd&gt;Shift&lt;/kbd&gt; trzyma jeden kierunek.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Przeciągnij, aby obrócić; &lt;kbd&gt;Ctrl&lt;/kbd&gt; zostawia kopię.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Przeciągnij, aby przeskalować; &lt;kbd&gt;Ctrl&lt;/kbd&gt; zostawia kopię.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby tak zostawić. &lt;kbd&gt;Ctrl&lt;/kbd&gt; zostawia kopię, &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Puść, aby zostawić tu kopię. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; tak zostawia. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; robi %n taką kopię, o krok dalej. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</numerusform>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; robi %n takie kopie, każdą o krok dalej. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</numerusform>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; robi %n takich kopii, każdą o krok dalej. &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Zestaw musi mieć nazwę, bez „=” i bez spacji na początku i końcu.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Inni nie mogą jeszcze zmienić żadnej wartości, więc nie ma czego zachować.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>Nie ma zestawu o nazwie „%1”.</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>To widzą inni. Zapisz plik i daj im go; tak się otworzy.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n liczba, która z tego powstawała, jest teraz zwykłą liczbą.</numerusform>
            <numerusform>%n liczby, które z tego powstawały, są teraz zwykłymi liczbami.</numerusform>
            <numerusform>%n liczb, które z tego powstawały, to teraz zwykłe liczby.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>Razem z tym zniknął %n zestaw, który nie ustawiał nic innego.</numerusform>
            <numerusform>Razem z tym zniknęły %n zestawy, które nie ustawiały nic innego.</numerusform>
            <numerusform>Razem z tym zniknęło %n zestawów, które nie ustawiały nic innego.</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>Nie znaleziono węższych zakresów, w których model by się trzymał.</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Ruszaj myszą, aby obracać widok, puść, aby zakończyć.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Ruszaj myszą, aby przesuwać widok, puść, aby zakończyć.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Ruch w górę przybliża, w dół oddala; puść, aby zakończyć.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>Nic nie zmieniono: tego nie da się tu zrobić.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>Płytka zablokowana: %1. Odblokuj ją w panelu Struktura, aby ją zmienić.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>„%1” tworzy operacja „%2”: edytuj źródło albo odłącz tę płytkę.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>Z „%1” nic by nie zostało; zostaje, jak było.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1: ścięto równo z podłożem.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1: płytka rozpadła się przy ścięciu równo z podłożem; zachowano największy kawałek.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>Nic nie wklejono: w tym, co skopiowano, nie ma płytek ani obrazu.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>Nic nie skopiowano: model jest już symetryczny.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>Nic nie usunięto: połączenie jest tam, gdzie spotykają się dwie płytki. Usuń jedną z nich albo wybierz rodzaj „Brak”.</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>„%1” to teraz bieżące ustawienia zamiast poprzednich.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Najpierw narysuj płytkę: nie ma jeszcze czego odbijać.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Najpierw narysuj płytkę: nie ma jeszcze czego powtarzać ani dzielić.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n krawędź nie ma wczepów: arkusze spotykają się tam zbyt płasko lub zbyt ostro albo jest za krótka. Pomoże mniej ścian albo plastry.</numerusform>
            <numerusform>%n krawędzie nie mają wczepów: arkusze spotykają się tam zbyt płasko lub zbyt ostro albo są za krótkie. Pomoże mniej ścian albo plastry.</numerusform>
            <numerusform>%n krawędzi nie ma wczepów: arkusze spotykają się tam zbyt płasko lub zbyt ostro albo są za krótkie. Pomoże mniej ścian albo plastry.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dodaje lustrzane odbicie zaznaczenia. &lt;kbd&gt;Enter&lt;/kbd&gt; odbija; &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Co zmienisz po jednej stronie, zmieni się też po drugiej. &lt;kbd&gt;Enter&lt;/kbd&gt; odbija; &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Raz czyni obie strony takimi samymi; potem każda jest osobna. &lt;kbd&gt;Enter&lt;/kbd&gt; odbija; &lt;kbd&gt;Esc&lt;/kbd&gt; anuluje.</translation>
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
        <translation>Szklanka wody</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Widelec</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Nóż</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Łyżka</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Książka</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Doniczka</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Pominięto ścianę: brakuje jej narożnika.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>Pominięto %n ścianę: brakuje jej narożnika.</numerusform>
            <numerusform>Pominięto %n ściany: brakuje im narożnika.</numerusform>
            <numerusform>Pominięto %n ścian: brakuje im narożnika.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Pominięto ścianę: położenie jej narożnika nie jest liczbą.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>Pominięto %n ścianę: położenie narożnika nie jest liczbą.</numerusform>
            <numerusform>Pominięto %n ściany: położenie narożnika nie jest liczbą.</numerusform>
            <numerusform>Pominięto %n ścian: położenie narożnika nie jest liczbą.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Pominięto ścianę: ma dwa razy ten sam narożnik.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>Pominięto %n ścianę: ma dwa razy ten sam narożnik.</numerusform>
            <numerusform>Pominięto %n ściany: mają dwa razy ten sam narożnik.</numerusform>
            <numerusform>Pominięto %n ścian: mają dwa razy ten sam narożnik.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Pominięto ścianę: występuje dwa razy.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>Pominięto %n ścianę: występuje dwa razy.</numerusform>
            <numerusform>Pominięto %n ściany: występują dwa razy.</numerusform>
            <numerusform>Pominięto %n ścian: występują dwa razy.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Odwrócono ścianę zwróconą w złą stronę.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>Odwrócono %n ścianę zwróconą w złą stronę.</numerusform>
            <numerusform>Odwrócono %n ściany zwrócone w złą stronę.</numerusform>
            <numerusform>Odwrócono %n ścian zwróconych w złą stronę.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>Powierzchnia ma dziurę: jedna krawędź jest otwarta.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>Powierzchnia ma dziury: %n krawędź jest otwarta.</numerusform>
            <numerusform>Powierzchnia ma dziury: %n krawędzie są otwarte.</numerusform>
            <numerusform>Powierzchnia ma dziury: %n krawędzi jest otwartych.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>Przy jednej krawędzi spotykają się więcej niż dwie ściany.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>Przy %n krawędzi spotykają się więcej niż dwie ściany.</numerusform>
            <numerusform>Przy %n krawędziach spotykają się więcej niż dwie ściany.</numerusform>
            <numerusform>Przy %n krawędziach spotykają się więcej niż dwie ściany.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>Przy jednej krawędzi spotykają się ściany, które nie mogą być zwrócone w tę samą stronę.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>Przy %n krawędzi spotykają się ściany, które nie mogą być zwrócone w tę samą stronę.</numerusform>
            <numerusform>Przy %n krawędziach spotykają się ściany, które nie mogą być zwrócone w tę samą stronę.</numerusform>
            <numerusform>Przy %n krawędziach spotykają się ściany, które nie mogą być zwrócone w tę samą stronę.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>Wnętrze było na zewnątrz; odwrócono.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Lukę w cięciu zamknięto gładką krzywą.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n lukę w cięciu zamknięto gładką krzywą.</numerusform>
            <numerusform>%n luki w cięciu zamknięto gładkimi krzywymi.</numerusform>
            <numerusform>%n luk w cięciu zamknięto gładkimi krzywymi.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>Płaszczyzna</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>Jak</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 nie podaje rozmiaru w mm ani calach; resztka jest przyjęta jako %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: obrys przecina sam siebie; przyjęto jego największy kawałek, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: linie dzielą resztkę na kawałki; przyjęto największy, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: w resztce są otwarte linie; to, co otoczyłyby po zamknięciu, zostaje wolne.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>Liczba</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linia</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Razem z płytkami, które już są</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>Krok X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Krok Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Krok Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Szyk</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Powtarza płytki wzdłuż linii w przestrzeni.</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>%1 – szyk</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Płytki</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Kliknij płytki do powtórzenia.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Przejście</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Tworzy przejścia między płytkami.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>%1 – przejście</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Kliknij po kolei płytki, które mają w siebie przechodzić.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Wzdłuż</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Kliknij płytkę, wzdłuż której to poprowadzić.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Liczba na odstęp</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Rozmieszczenie</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Przebieg</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Równy</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>Wolne końce</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Dopasowanie</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatycznie</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Jak narysowano</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Odwrotnie</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Powtórzenia</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wzrost</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Wielkość kopii</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Zmienność wielkości ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Zmienność kąta ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Ziarno</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Najmniejsza</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Granice</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Najwyżej</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Gałęzie</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Wstawia kopie płytki ze wszystkim, co na niej jest, w miejsce jej płytek podrzędnych, i tak wiele razy.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>%1 – gałęzie</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Korzeń</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Kliknij płytkę, która ma się rozgałęziać.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Trzyma ją</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Kliknij płytkę, która ją trzyma: kopie będą trzymane tak samo.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Płytki podrzędne</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Kliknij dołączone płytki, w których miejsce wejdą kopie.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Podział</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Dzieli zbyt dużą płytkę na komórki, które trzymają się razem.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>%1 – podział</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Płytka</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Kliknij płytkę do podzielenia.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Dopasuj do arkusza</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Komórki</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Szerokość komórki</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Wysokość komórki</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Krawędź</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Prosta z łącznikami</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Puzzle</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Krawędzie</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Łączniki na krawędź</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Wielkość łącznika</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Scalaj skrawki poniżej</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Strona</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Naprzód</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Obie</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Równa głębokość wewnątrz</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>W drugiej płytce tkwi taka sama długość każdej kopii</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Rząd</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Powtarza płytkę w rzędzie wzdłuż innej płytki.</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>%1 – rząd</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Koło</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Gwiazda</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Koło zębate</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Otwory</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Narysowany wycinek</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Wycinki</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Promień zewnętrzny</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Promień wewnętrzny</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Ząb</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Zaokrąglony</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Prostokątny</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapezowy</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>Zastosuj do</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>%1 – koło</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>%1 – gwiazda</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 – otwory</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>%1 – rozeta</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>%1 – koło zębate</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Kontur kołowy</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Zmienia płytkę w koło, gwiazdę lub koło zębate albo wycina w niej takie otwory.</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Kliknij płytkę do ukształtowania.</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Kliknij płytkę do powtórzenia.</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Cała gałąź</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Ze wszystkim, co jest do niej dołączone</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Powtarzaj według</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Odstęp</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Wg miejscowej grubości</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Cała płytka</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>Wzdłuż szczeliny</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stopień</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>Nie poniżej</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Na zewnątrz</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Wewnątrz</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Kąt do krawędzi</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>Na całym obwodzie</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Po obwodzie</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Powtarza płytkę wokół konturu innej płytki.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>%1 – wachlarz</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Płaszczyzny</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>w poprzek X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>w poprzek Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>w poprzek Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>w poprzek X i Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>w poprzek X i Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>w poprzek Y i Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>wzdłuż krzywej</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Plastry</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Według</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>W każdym kierunku</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Przesunięcie</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>Wszystkich płaszczyzn, jako część ich odstępu</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Najmniejszy kawałek</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>W mm²; mniejsze są pomijane, podobnie jak te, które wszędzie są cienkie</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Puste w środku</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Zostaje tylko ścianka wzdłuż konturu</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Ścianka</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Tnie siatkę na płytki oddające jej kształt.</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Kliknij płytkę, wzdłuż której konturu to poprowadzić.</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Kliknij płytki, których to dotyczy.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Dotyczy</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Cały model</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Zaznaczenie</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Odbicie</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Powtarza wszystko narysowane po jednej stronie także po drugiej.</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Kliknij płytkę, względem której odbić.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Płaszczyzna</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>Płaszczyzna płytki</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symetria</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>Połącz na płaszczyźnie</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Symetria obrotowa</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Powtarza wszystko narysowane raz dookoła osi.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Oś</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Kliknij dwie płytki, których szczelina jest osią.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Pionowa</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Szczelina</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>jak płytka</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>wokół Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>wokół X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>wokół Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Jak</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Kliknij płytkę, do której mają być równoległe.</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>automatycznie</translation>
    </message>
    <message>
        <source>on</source>
        <translation>wł.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wył.</translation>
    </message>
    <message>
        <source>%1&#x202f;mm</source>
        <translation>%1&#x202f;mm</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 makes nothing yet: choose its “%2”.</source>
        <extracomment>%1 is the name of an operation, %2 what it asks for: &quot;Along&quot;</extracomment>
        <translation>%1: nic jeszcze nie powstaje; wybierz „%2”.</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1: usunięto płytkę „%2”, której używa ta operacja. Nic nie powstaje, dopóki nie wybierze się innej.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: nic nie powstaje, bo płytki się nie krzyżują.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: nic nie powstaje, bo w zakresie nie ma miejsca.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: nie ma czego dzielić, płytka mieści się w jednej komórce.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: nie udało się obliczyć, brakuje płytek.</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: zatrzymano na 1 płytce.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1: zatrzymano na %n płytce.</numerusform>
            <numerusform>%1: zatrzymano na %n płytkach.</numerusform>
            <numerusform>%1: zatrzymano na %n płytkach.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: pominięto 1 płytkę, bo nic jej nie trzyma.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%1: pominięto %n płytkę, bo nic jej nie trzyma.</numerusform>
            <numerusform>%1: pominięto %n płytki, bo nic ich nie trzyma.</numerusform>
            <numerusform>%1: pominięto %n płytek, bo nic ich nie trzyma.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: nic nie powstaje, bo nie ma podkładu albo jego pliku.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1: pominięto 1 mały kawałek.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%1: pominięto %n mały kawałek.</numerusform>
            <numerusform>%1: pominięto %n małe kawałki.</numerusform>
            <numerusform>%1: pominięto %n małych kawałków.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: drukuj w skali 100%</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Arkusz %1, strona %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Odłącz</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
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
        <translation>Page Up</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page Down</translation>
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
        <translation>Spacja</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Lewo</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Prawo</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Góra</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Dół</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Zatrzymano: %1. Obliczenie ruszy ponownie, gdy zmieni się model.</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>Nie udało się obliczyć: %1. Powód: %2.</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>co można zrobić z problemami</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Obliczanie: %1…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>Obliczanie: %1… %2%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>połączenia i szczeliny</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>kontrola</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>kolejność składania</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>czy wytrzyma</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>ile utrzyma, gdy płytki się uginają</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>ile utrzyma każde miejsce płytki</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>poszycie</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>jak części leżą na arkuszach</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>co magnesy robią z podkładów</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>co uwolni części, które się blokują</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>Ustaw cięcie</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>Edytuj: %1</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień materiał: %1</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Zmień materiał %n płytki</numerusform>
            <numerusform>Zmień materiał %n płytek</numerusform>
            <numerusform>Zmień materiał %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Wstaw: %1</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Postaw na podłożu</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Poszerz podstawę: %1</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dodaj stopkę: %1</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Połącz: %1 i %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>Przesuń: %1 → %2</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>Przesuń %n płytkę → %1</numerusform>
            <numerusform>Przesuń %n płytki → %1</numerusform>
            <numerusform>Przesuń %n płytek → %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Odwróć szczeliny: %1</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Przesuń o %2: %1</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Umożliw złożenie</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Podeprzyj stopką: %1</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przedłuż do podłoża: %1</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>Przedłuż %n płytkę do podłoża</numerusform>
            <numerusform>Przedłuż %n płytki do podłoża</numerusform>
            <numerusform>Przedłuż %n płytek do podłoża</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1: grubość %2</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Obróć do 90°: %1</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Poszerz w słabym miejscu: %1</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: odwróć szczeliny</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: punkt styku → %3%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: przywróć automatyczne</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: rodzaj → nakładka krzyżowa</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: rodzaj → długa nakładka</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: rodzaj → gniazdo</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: rodzaj → wypusty</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: rodzaj → brak</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Przytnij: %1 (do: %2)</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przerysuj: %1</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Narysuj otwór: %1</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Narysuj: %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Importuj: %1</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Odrysuj: %1</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień kształt: %1</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>Połóż %1 na: %2</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przesuń ciężar: %1</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Ustaw ciężar na %1</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Zmień nazwę ciężaru: %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Usuń ciężar</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Naciśnij: %1</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przesuń nacisk: %1</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Obróć nacisk: %1</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Ustaw nacisk na %1</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Zmień nazwę nacisku: %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Usuń nacisk</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Rozłóż obciążenie: %1</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Obciąż też kopie: %1</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Nie obciążaj kopii: %1</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dociągnij podkłady: %1</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Dociągnij podkłady do %n płytki</numerusform>
            <numerusform>Dociągnij podkłady do %n płytek</numerusform>
            <numerusform>Dociągnij podkłady do %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zwolnij podkłady: %1</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Zwolnij podkłady od %n płytki</numerusform>
            <numerusform>Zwolnij podkłady od %n płytek</numerusform>
            <numerusform>Zwolnij podkłady od %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Oznacz: %1</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień znak: %1</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Usuń znak: %1</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Skaluj model do %1%</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień w koło: %1</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień w elipsę: %1</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień otwór w koło: %1</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień otwór w elipsę: %1</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Wyprostuj linie: %1</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Wyprostuj narożniki: %1</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Odsuń od krawędzi: %1</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dodaj punkt: %1</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Usuń punkt: %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>Usuń %n punkt: %1</numerusform>
            <numerusform>Usuń %n punkty: %1</numerusform>
            <numerusform>Usuń %n punktów: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przesuń uchwyt: %1</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Wygnij kontur: %1</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przesuń punkt: %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>Przesuń %n punkt: %1</numerusform>
            <numerusform>Przesuń %n punkty: %1</numerusform>
            <numerusform>Przesuń %n punktów: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmień punkt: %1</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>Zmień %n punkt: %1</numerusform>
            <numerusform>Zmień %n punkty: %1</numerusform>
            <numerusform>Zmień %n punktów: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przesuń: %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>Przesuń %n płytkę</numerusform>
            <numerusform>Przesuń %n płytki</numerusform>
            <numerusform>Przesuń %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Obróć: %1</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>Obróć %n płytkę</numerusform>
            <numerusform>Obróć %n płytki</numerusform>
            <numerusform>Obróć %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Skaluj: %1</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>Skaluj %n płytkę</numerusform>
            <numerusform>Skaluj %n płytki</numerusform>
            <numerusform>Skaluj %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kopiuj: %1</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>Kopiuj %n płytkę</numerusform>
            <numerusform>Kopiuj %n płytki</numerusform>
            <numerusform>Kopiuj %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Odbita kopia: %1</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Odbita kopia %n płytki</numerusform>
            <numerusform>Odbite kopie %n płytek</numerusform>
            <numerusform>Odbite kopie %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ustaw prostopadle: %1</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>Ustaw prostopadle %n płytkę</numerusform>
            <numerusform>Ustaw prostopadle %n płytki</numerusform>
            <numerusform>Ustaw prostopadle %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Wyrównaj do osi: %1</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>Wyrównaj do osi %n płytkę</numerusform>
            <numerusform>Wyrównaj do osi %n płytki</numerusform>
            <numerusform>Wyrównaj do osi %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Umieść na innej płytce: %1</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Uwolnij: %1</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>Uwolnij %n płytkę</numerusform>
            <numerusform>Uwolnij %n płytki</numerusform>
            <numerusform>Uwolnij %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dołącz: %1</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>Dołącz %n płytkę</numerusform>
            <numerusform>Dołącz %n płytki</numerusform>
            <numerusform>Dołącz %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Zmień podążanie: %1</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Zmień podążanie %n płytki</numerusform>
            <numerusform>Zmień podążanie %n płytek</numerusform>
            <numerusform>Zmień podążanie %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zablokuj: %1</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>Zablokuj %n płytkę</numerusform>
            <numerusform>Zablokuj %n płytki</numerusform>
            <numerusform>Zablokuj %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Odblokuj: %1</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>Odblokuj %n płytkę</numerusform>
            <numerusform>Odblokuj %n płytki</numerusform>
            <numerusform>Odblokuj %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>Ułóż na arkuszu: %1</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>Przypnij: %1</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>Przypnij %n część</numerusform>
            <numerusform>Przypnij %n części</numerusform>
            <numerusform>Przypnij %n części</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>Odepnij: %1</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>Odepnij %n płytkę</numerusform>
            <numerusform>Odepnij %n płytki</numerusform>
            <numerusform>Odepnij %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Odepnij wszystkie części</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Zmień obracanie: %1</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Zmień obracanie %n płytki</numerusform>
            <numerusform>Zmień obracanie %n płytek</numerusform>
            <numerusform>Zmień obracanie %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zachowaj symetrię: %1</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>Zachowaj symetrię %n płytki</numerusform>
            <numerusform>Zachowaj symetrię %n płytek</numerusform>
            <numerusform>Zachowaj symetrię %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Pozwól na różne połowy: %1</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Pozwól na różne połowy %n płytki</numerusform>
            <numerusform>Pozwól na różne połowy %n płytek</numerusform>
            <numerusform>Pozwól na różne połowy %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Dodaj podkład: %1</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Usuń podkład: %1</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Zmień podkład: %1</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Przesuń podkład: %1</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Obróć podkład: %1</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Skaluj podkład: %1</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>Wyrównaj: %1 i %2</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ukryj podkład: %1</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Pokaż podkład: %1</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Zaproponuj %n płytkę: %1</numerusform>
            <numerusform>Zaproponuj %n płytki: %1</numerusform>
            <numerusform>Zaproponuj %n płytek: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Zbuduj ze ścianek: %1</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Rozwiń: %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>Dodaj: %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>Ustaw: %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>Zmień nazwę: %1 → %2</translation>
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
        <translation>Usuń: %1</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Zachowaj zestaw: %1</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Ustaw zestaw: %1</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Usuń zestaw: %1</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Udostępnij do dopasowania</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Edytuj projekt</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Ustaw wartości</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Zawęź zakresy</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>Zmień nazwę: %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Usuń %n płytkę</numerusform>
            <numerusform>Usuń %n płytki</numerusform>
            <numerusform>Usuń %n płytek</numerusform>
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
        <translation>Zmień: %1</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Zmień kolejność: %1</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Pomiń: %1</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>Pomiń %n płytkę</numerusform>
            <numerusform>Pomiń %n płytki</numerusform>
            <numerusform>Pomiń %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Przywróć pominiętą płytkę</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Wytnij: %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>Wytnij %n płytkę</numerusform>
            <numerusform>Wytnij %n płytki</numerusform>
            <numerusform>Wytnij %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Wklej: %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>Wklej %n płytkę</numerusform>
            <numerusform>Wklej %n płytki</numerusform>
            <numerusform>Wklej %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Zachowaj wymiar</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Usuń wymiar</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Nadaj symetrię</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Włącz: %1</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Wyłącz: %1</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Utrwal: %1</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Odłącz: %1</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Usuń otwory: %1</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Usuń otwory %n płytki</numerusform>
            <numerusform>Usuń otwory %n płytek</numerusform>
            <numerusform>Usuń otwory %n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Przesuń płaszczyzny: %1</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Zmień liczbę płaszczyzn: %1</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Zmień odstęp płaszczyzn: %1</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1: za małe lub za cienkie na płytki grubości %2.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1: nie znaleziono płytek, które trzymałyby się nawzajem i stały.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1: nie znaleziono kolejnej płytki, która zmieściłaby się między istniejącymi.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1: znaleziono tylko %n płytkę; każda następna by jej przeszkadzała albo nic by jej nie trzymało.</numerusform>
            <numerusform>%1: znaleziono tylko %n płytki; każda następna by im przeszkadzała albo nic by jej nie trzymało.</numerusform>
            <numerusform>%1: znaleziono tylko %n płytek; każda następna by im przeszkadzała albo nic by jej nie trzymało.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1: nie znaleziono mniej stojących płytek niż %n.</numerusform>
            <numerusform>%1: nie znaleziono mniej stojących płytek niż %n.</numerusform>
            <numerusform>%1: nie znaleziono mniej stojących płytek niż %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1: obniżono w podłoże o %2, aby płytki stały na płaskiej stopce.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1: obniżono w podłoże o %2, a płytki mają stopki wysokie do %3, aby stały.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>To się porusza; widać tylko pierwszy obraz.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>Pominięto %n tekst.</numerusform>
            <numerusform>Pominięto %n teksty.</numerusform>
            <numerusform>Pominięto %n tekstów.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>Pominięto %n obraz.</numerusform>
            <numerusform>Pominięto %n obrazy.</numerusform>
            <numerusform>Pominięto %n obrazów.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Brakuje liczby, nazwy albo działania.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Wyrażenie może mieć najwyżej %1 znaków; to jest dłuższe.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>Przy „%1” wyrażenie ma już więcej liczb, nazw i znaków niż %2.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>Przy „%1” jest więcej zagnieżdżonych nawiasów lub znaków niż %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>Nie da się tu odczytać „%1”.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Po „%1” czegoś brakuje.</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Przed „%1” czegoś brakuje.</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Między „%1” a „%2” brakuje znaku, na przykład + lub *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>Nawias przy „%1” nie jest zamknięty.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Po „%1” jest o jeden nawias zamykający za dużo.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>Tekst przy „%1” nie ma zamykającego cudzysłowu.</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>„%1” może być jedną liczbą albo dwiema: wpisz kropkę albo spację po przecinku.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>„%1” to jednostka; przed nią musi stać liczba.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>„%1” można rozumieć na dwa sposoby: ujmij „%2” w nawias.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>„%1” to drugie porównanie; dwa łączy and(…; …).</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>Nie ma funkcji o nazwie „%1”.</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>„%1” przyjmuje w nawiasie tyle argumentów: %2, a nie %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>„%1” przyjmuje w nawiasie co najmniej tyle argumentów: %2, a nie %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>„%1” przyjmuje w nawiasie najwyżej tyle argumentów: %2, a nie %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Nie ma wartości o nazwie „%1”.</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>„%1” to grubość materiału; tutaj nie ma jednego materiału.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>„%1” to %2, więc nie może mieć własnej jednostki.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>„%1” to %2, a „%3” to %4; dodawać i porównywać można tylko to, co jednakowe.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>„%1” to %2; nie da się tym liczyć.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>„%1” to %2, a potrzebne jest tu: %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>„%1” to %2; można podnieść tylko do małej potęgi całkowitej, na przykład 2, a nie „%3”.</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>„%1” mnoży zbyt wiele długości, kątów lub mas.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>„%1” to %2; nie da się z tego wyciągnąć pierwiastka.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>„%1” jest równe 0, a przez 0 nie da się dzielić.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>„%1” jest ujemne i nie ma pierwiastka.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>Tangens „%1” jest nieskończony.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>„%1” nie leży między −1 a 1, więc nie odpowiada żadnemu kątowi.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>„%1” nie jest liczbą.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>„%1” nie jest większe od 0; do takich kroków nie da się zaokrąglać.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>„%1” jest za duże.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>„%1” to %2, a nie liczba całkowita; zrobi ją z tego round, floor lub ceil.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>„%1” to %2; musi być co najmniej %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>„%1” to %2; może być najwyżej %3.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>„%1” to „%2”, a tego nie ma do wyboru.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>„%1” daje tekst dłuższy niż %2 znaków.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Ta wartość zależy od samej siebie: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Ta wartość zależy od „%1”, a „%1” nie ma teraz wartości.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Dwie wartości mają nazwę „%1”.</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>„%1” nie może być nazwą; nazwa to litera, potem litery, cyfry i _, najwyżej %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>„%1” nie może być nazwą, bo coś znaczy w wyrażeniach.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Tej wartości już nie ma.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>Nawias klamrowy przy „%1” nie jest zamknięty.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>zwykła liczba</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>liczba całkowita</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>długość</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>objętość</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>kąt</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>masa</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>tekst</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>tak lub nie</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>ani długość, ani kąt, ani masa, ani zwykła liczba</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Płytka %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Płytki %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 i %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>Nie ma materiału „%1”. Wybierz któryś z pliku albo z listy materiałów, na przykład Birch plywood, Acrylic lub Card.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 nie zostawia miejsca na szczeliny w materiale %2: jego luz to %3 mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 nie pasuje do materiału %2, który ma grubość %3 mm.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>plik %1</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>plik %1 z %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 lub %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1 lub %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>Użycie: %1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Pokazuje tę pomoc.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>Nie podano pliku.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Za dużo plików: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Nadaje nazwanej wartości modelu inną liczbę albo ustawia wszystko z zestawu; można powtarzać.</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Grubość każdego materiału.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Tnie każdą płytkę z tego materiału albo z materiału z pliku .fff.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Pełna szerokość, którą usuwa maszyna.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Luz dodawany do szczelin; mniej niż 0 dla pasowania na wcisk.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Mówi o każdej rzeczy poprawionej w pliku, gdzie to było.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: znaleziono: „%2”, oczekiwano: %3.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: znaleziono: „%2”, oczekiwano: liczba od %3 do %4.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: znaleziono: „%1”, oczekiwano: szerokość x wysokość w mm, na przykład 600x400.</translation>
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
        <translation>Zsuń razem wszystkie listewki (%1): to, czego ich szerokości brakuje do %2 mm, podzielone przez %1, to rzaz.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Mostki, które trzymają każdą część w arkuszu, i ich szerokość w mm, na przykład 3:0.4 (brak).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Zaczyna i kończy każde cięcie tak daleko obok linii, w odpadzie (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Tnie tylko raz stykające się krawędzie dwóch części; z --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Zamiast części zapisuje próbkę: szczeliny o numerowanych szerokościach i listewki, które pokażą rzaz.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: znaleziono: „%1”, oczekiwano: liczba od 0 do %2, potem dwukropek i szerokość od %3 do %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: znaleziono: „%2”, oczekiwano: liczba od 0 do %3.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Krok %1: zacznij od części %2</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Krok %1: zacznij osobną grupę od części %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Krok %1: część %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Krok %1: części %2 jako całość, co łączy to, co złożono w krokach %3 i %4</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Płytki: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Połączenia: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 i %2 się spotykają, ale żadna szczelina nie pozwala ich w siebie wsunąć.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Wszystkie płytki trzymają się razem.</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>część z: %1</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Niepołączone z resztą: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Rozmiar %1 × %2 × %3 mm (szerokość, wysokość, głębokość)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Masa %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Materiał %1, %2 mm, arkusze %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Część %1: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, połączenia %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>Nie ma czego ciąć: model nie ma płytek.</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>Nie ma czego ciąć: szczeliny nic nie zostawiają z żadnej płytki.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>Brakuje -o: podaj plik do zapisania.</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: plik musi mieć nazwę.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: tego rodzaju pliku nie da się zapisać; oczekiwano: %2.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Umieszcza obok modelu siatkę, obraz lub rysunek (SVG) o tym największym wymiarze w mm; można podać kilka razy.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: znaleziono: „%1”, oczekiwano: plik albo plik i jego rozmiar w mm, na przykład ball.stl@80.</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>Plik .fff do zapisania; - to standardowe wyjście.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Skaluje siatkę do tego największego wymiaru; bez niego taka, jak podaje plik, inaczej 254.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: znaleziono: „%2”, oczekiwano: liczba całkowita od %3 do %4.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: ten element jest za duży na pasek.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Długość: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Gęstość: %1%</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Części: %1, arkusze: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm, %3: części: %4, pokrycie %5%</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: część jest za duża na swój arkusz.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: znaleziono: „%1”, oczekiwano: groups lub files.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: nie ma maszyny „%1”; oczekiwano: %2 albo plik .json.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files wymaga nazwy: standardowe wyjście to tylko jeden plik.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>Szczeliny są narysowane na szerokość %1 mm.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>Szczeliny są narysowane na szerokość %1 mm (%2 − rzaz %3).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Są jeszcze arkusze z wcześniejszego eksportu: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Płaty: %1, trójkąty: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Miejsca, które zostają otwarte: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: %2 m cięcia, około %3 min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>Arkusze są większe niż pole robocze %1 x %2 mm; wybierz inne przez --sheet.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Części: %1, arkusze: %2, wykorzystanie %3%.</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>Plik do zapisania; - to standardowe wyjście.</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1; potrzebne, gdy nie mówi tego nazwa pliku.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Pomija pasek 100 mm obok arkuszy.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Od krawędzi arkusza do najbliższego cięcia (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Między sąsiednimi cięciami (2).</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Tylko ćwierćobroty, dla arkuszy ze słojami.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Rozkłada części według ich prawdziwych obrysów, szukając tyle sekund; 0 bierze pierwszy układ (według prostokątów).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: jeden SVG z grupą na arkusz; files: OUT-1.svg, OUT-2.svg i tak dalej (groups).</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>Maszyna, która tnie, ze względu na kolory, prędkości i G-code: %1; albo plik .json z własną (generic).</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Zamiast brył zapisuje kształt, który zarysowują płytki, jako powierzchnię (%1).</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Przy -o - brakuje formatu: --format %1.</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: ten rodzaj pliku nie może go zawierać; oczekiwano: %1.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: ten rodzaj pliku nie może jej zawierać; oczekiwano: %1.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Rozmiar obrazu w pikselach (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 do iso4, front, right, top, left, back, bottom lub fit: znowu przód (iso1).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: znaleziono: „%1”, oczekiwano: szerokość x wysokość w pikselach do %2, na przykład 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: znaleziono: „%1”, oczekiwano jednego z: %2.</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Stoi.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Przewraca się.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Przewraca się: opiera się tylko na jednej linii.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Pewna część nie ma na czym stać.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>Nie stoi na podłożu.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Ześlizguje się po podłożu.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>Jego części poruszają się względem siebie.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Utrzyma.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Ledwo utrzyma: może pęknąć w narożniku.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Złamie się.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Połączenie się rozsuwa.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>Wytrzymałość oblicza się tylko dla tego, co stoi nieruchomo.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Bez oceny: wytrzymałość materiału jest nieznana.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Nie udało się obliczyć, czy utrzyma.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Stałoby, %1.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Za słabe: utrzyma, ale bez wymaganego zapasu bezpieczeństwa.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Utrzymałoby, %1.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 naciska na podłoże siłą %2 N.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>Połączenie %1–%2 rozsuwa siła %3 N: sklej je albo odwróć jego szczeliny.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>Nie udało się obliczyć, jak ugina się „%1”; płytka jest traktowana jako sztywna.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>Nie udało się obliczyć, jak uginają się płytki; są traktowane jako sztywne.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Połączenia mogą dzielić obciążenie na więcej niż jeden sposób (układ niewyznaczalny, %1); liczy się najgorszy.</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>Nie udało się obliczyć naprężeń: %1.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1: bez oceny, wytrzymałość materiału jest nieznana.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Nacisk %1 N nie trafia w materiał „%2”; przejmuje go najbliższe miejsce.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Ciężar %1 nie trafia w materiał „%2”; przejmuje go najbliższe miejsce.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 łącznie</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1 N łącznie</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 razy obciążenie</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>Najsłabsze miejsce, %1: %2 wytrzymałości materiału w przewężeniu, %3 w narożniku.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Ugina się o %1 mm, najbardziej: %2.</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Może pęknąć od %1.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Złamie się przy %1.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Ze wszystkim, co na nim leży, waży %1 N.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>znaleziono: „%1”, oczekiwano: NAZWA=WARTOŚĆ, na przykład width=400.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>znaleziono: „%1”, oczekiwano: NAZWA=WARTOŚĆ, na przykład width=400, albo zestaw: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>„%1” może znaczyć %2 lub %3; napisz jedno z nich.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>model nie ma nazwanych wartości.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>nie ma wartości „%1”; oczekiwano: %2.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Nie ma wartości, którą inni mogą zmieniać, która ma zakres i jest używana.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Wypróbowano: %1 z %2 skrajnych ustawień zakresów, warianty pośrednie: %3.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Wszystkie są dobre.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 z %2 zawodzi:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Gdzie:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Ściany: %1, powłoki: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>Płaszczyzna tego nie przecina.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Otwór: %1 mm², punkty: %2</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Pętla: %1 mm², punkty: %2</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Pole: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Punkt płaszczyzny i jej normalna, sześć liczb z przecinkami.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Najpierw skaluje siatkę do tego największego wymiaru i stawia ją na podłożu.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Wypisuje JSON, dla innych programów.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>Brakuje --plane.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: znaleziono: „%1”, oczekiwano: sześć liczb, z których trzy ostatnie to kierunek.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Bez wczepów, gdzie arkusze spotykają się pod kątem mniejszym niż 30° lub większym niż 150°: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Bez wczepów, gdzie jeden arkusz mija drugi albo go nie sięga: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Bez wczepów na krawędziach, które są za krótkie na trzy: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 i %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Arkusza %1 mm nie da się zginać, oczekiwano najwyżej %2 mm; --stock wybiera inny.</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: płaskich kawałków jest %2, oczekiwano najwyżej %3; z --faces będzie ich mniej.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: żaden płaski kawałek nie jest dość duży na płytkę; --size go powiększa.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Rozwinięcia: %1, zgięcia: %2, szwy: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Najpierw upraszcza siatkę do tylu trójkątów; te, które razem leżą płasko, są jednym kawałkiem.</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Rozwinięcia do zgięcia wzdłuż naciętych linii, z arkusza do 3 mm, zamiast płaskich arkuszy.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Z --unfold: szerokość skrzydełek do klejenia; 8 mm dla arkusza do 1,5 mm, inaczej 0 mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap należy do --unfold.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Kawałki za małe na płytkę: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Płytki: %1, połączenia: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Jak długo szukać (10); 0 bierze pierwszy układ.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Inna liczba daje inny układ, ta sama ten sam.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Jak wolno obracać części: none, 180, 90 lub free.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Od krawędzi arkusza do najbliższego cięcia.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Między sąsiednimi cięciami.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: znaleziono: „%1”, oczekiwano: none, 180, 90 lub free.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>Model nie ma operacji.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 płytka</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wył.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Wypisuje JSON, dla innych programów; kroki liczy się od 0.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Największa odległość cięciw od krzywych (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: tego rodzaju pliku nie da się zapisać; oczekiwano: .png.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: znaleziono: „%1”, oczekiwano: labels, checks, stress, forces, skin lub kilka rozdzielonych przecinkami.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: nie pokazano sił; model nie stoi albo nie udało się ich obliczyć. „check” mówi dlaczego.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>Plik PNG do zapisania; - to standardowe wyjście.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: nazwy płytek; checks: obrysowuje płytki z problemem; stress: najsłabsze przekroje; forces: co przenoszą stopki i połączenia; skin: kształt, który zarysowują płytki.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Naprężenia z elementów skończonych, w kolorach na całych płytkach; trwa kilka sekund.</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Obraz wymaga ekranu z OpenGL 3.3; nie ma takiego.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>Nie udało się zapisać obrazu jako pliku PNG.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>Model, od którego zacząć; bez niego nowy.</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: znaleziono: „%1”, oczekiwano: X, Y, Z, XY, XZ, YZ lub radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>Podano i --count, i --spacing; oczekiwano jednego z nich.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: płaszczyzny wokół osi nie mają odstępu; oczekiwano: --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>Osie, w poprzek których leżą płaszczyzny: X, Y, Z, dwie z nich dla kraty albo radial: wokół pionowej osi (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Płaszczyzny w każdym kierunku (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>Od płaszczyzny do płaszczyzny.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: żadna płaszczyzna nie wycina dość dużej płytki.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size jest do .png; PDF ma rozmiar swojego papieru.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper jest do .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: znaleziono: „%1”, oczekiwano: a4 lub letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Krok %1 z %2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 lub letter (domyślnie tak, jak jest przyjęte w danym kraju).</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Ile płytek (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Inna liczba daje inne płytki (1).</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Zestawy: %1. Ustawiony: %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Zestawy: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>Model nie ma nazwanych wartości.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Próbuje zakresów wartości, które inni mogą zmieniać.</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Inna liczba próbuje innych miejsc, ta sama tych samych.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>jest więcej komórek niż nazw.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Plik CSV: nazwy wartości i wiersz liczb dla każdego wariantu.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>Folder do zapisu; jeśli go nie ma, zostanie utworzony.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>Co zapisać z każdego (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>Potrzebne są i --table, i -o.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: znaleziono: „%1”, oczekiwano: rodzaj pliku do cięcia.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: nie znaleziono wiersza liczb, oczekiwano go pod nazwami.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: cudzysłów nie jest zamknięty.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: nie można utworzyć folderu.</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Kładzie ciężar na płytce, na jej środku albo w X,Y w mm: „Rib 4=350g”, „Rib 4@10,25=0.35kg”. Można powtarzać.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: oczekiwano: NAZWA=MASA, na przykład „Rib 4=350g”.</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: po znaku = oczekiwano: masa większa od 0, do 1000000 kg, z g, kg, oz lub lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: nie ma płytki „%2”.</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: szczeliny nic nie zostawiają z „%2”.</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: dwie kolumny nazywają się &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: tego rodzaju pliku nie da się zapisać; oczekiwano: .pdf, .html lub .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size jest do .png; strona internetowa dopasowuje się do ekranu.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>Nie udało się utworzyć obrazu kroków.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Plik PDF ze wszystkimi krokami (- to standardowe wyjście), OUT.html dla strony internetowej, na której można obracać model, także na telefonie, albo OUT.png dla OUT-01.png, OUT-02.png i tak dalej.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: tyle resztek materiału %1 to za dużo.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Brakujące arkusze materiału %1: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Kroków nie ma wśród plików: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Arkusze materiału %1 nie mają miejsca między marginesami %2 mm.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: znaleziono „%1”, oczekiwano szerokość x wysokość w mm, np. 300x200, lub pliku .svg, a za nimi, ile ich jest, np. :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Rozmiar arkusza, np. 600x400; z :N za nim, ile ich jest.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: model nie ma materiału „%2”; jest cięty z: %3.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: model jest cięty z: %2. Podaj, z czego jest ta resztka, np. „%3=%1”.</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Arkusz innego rozmiaru albo to, co z niego zostało, jako największy obrys z pliku .svg w naturalnej wielkości; jest zużywany przed całymi. Z :N na końcu jest ich tyle. W modelu z kilku materiałów z nazwą materiału na początku: „Birch plywood=300x200”. Można powtarzać.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Zostawia tylko ścianki tej szerokości wzdłuż konturów i tam, gdzie krzyżują się inne.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Graweruje numery każdego połączenia w osobnym kolorze, takim samym na obu częściach.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: ten rodzaj pliku nie może ich zawierać; oczekiwano %1.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Cięte raz dla dwóch części: %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>Żadne krawędzie dwóch części się nie stykają: nic nie jest cięte tylko raz. Z --spacing 0 mogą się stykać krawędzie proste.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>Szczeliny od %1 do %2 mają luz od %3 do %4 mm: wciskaj w nie pasek i nadaj materiałowi luz tej, która pasuje.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>Brak miejsca na wejścia i wyjścia wszystkich cięć: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>O FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licencje</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Do zgłaszania błędów</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Rysuj płaskie części w 3D, od razu sprawdzaj, jak do siebie pasują, i wycinaj je. Działa bez konta i nic nie opuszcza tego komputera.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Według „FlatFitFab: Interactive Modeling with Planar Sections”, J. McCrae, N. Umetani i K. Singh (UIST 2014). Wolne oprogramowanie na licencji GNU General Public License, wersja 3 lub nowsza.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Z czego zbudowano ten program</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Tekst licencji</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Ten program</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Okna, pliki i tekst</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Dokładna geometria</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Wektory i macierze</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Cięcie i odsuwanie obrysów</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Odczyt rysunków</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Rozpakowywanie rysunków</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modele z obrazami i siatkami</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Części używane przez CGAL</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Liczby bez zaokrąglania</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Liczby o wielu cyfrach</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Wyniki, które mogą być błędami</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>Model na stronach internetowych z krokami</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Edycja</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Płytka</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>Operacja</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Kierunek patrzenia</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Panele</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Rysuj na płaszczyźnie</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Rysuj na niej</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Rozmieść</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Zaznacz</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Pasek narzędzi do dopasowania</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>przed chwilą</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minutę temu</numerusform>
            <numerusform>%n minuty temu</numerusform>
            <numerusform>%n minut temu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n godzinę temu</numerusform>
            <numerusform>%n godziny temu</numerusform>
            <numerusform>%n godzin temu</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>wczoraj</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n dzień temu</numerusform>
            <numerusform>%n dni temu</numerusform>
            <numerusform>%n dni temu</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Starsze niż rysunek</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: starsze niż rysunek</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Oceny</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>Utrzyma</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>Bez uginania</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>Tej płytki nie ma</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>W tej postaci nie stoi</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>W tej postaci się złamie</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Wytrzymałość nieznana</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>obliczanie… %1%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>obliczanie…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zatrzymano</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>nie udało się obliczyć</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Liczby narzędzia rysowania</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Odległość</translation>
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
        <translation>Długość</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kąt</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>W prawo</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>W górę</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Na zewnątrz</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopie</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Starsze niż rysunek</translation>
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
        <translation>Dobrze</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Nieznane</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Ostrzeżenie</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1 w %n miejscu</numerusform>
            <numerusform>%1 w %n miejscach</numerusform>
            <numerusform>%1 w %n miejscach</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 z %2: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>Kontrola zaczyna się od pierwszej płytki.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Sprawdzanie…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Starsze niż rysunek</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Nie ma jeszcze płytki do sprawdzenia.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Brak problemów.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Sprawdzanie trwa; na razie brak problemów.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Problem %1 z %2: %3.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Sprawdzanie trwa. Zostanie to zrobione, gdy tylko wynik będzie znany.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>Model się zmienił; tego nie da się już zrobić.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Gotowe: %1.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Po kliknięciu: %1.</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>Problem %1 z %2, miejsce %3 z %4: %5.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>Eksportuj do</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Znajdź polecenie</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Wpisz, co chcesz zrobić</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Pasujące polecenia</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Brak pasujących poleceń</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Spróbuj innego słowa</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Zapisz próbkę pasowania</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 – próbka</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Zapisano próbkę pasowania w %1. Wytnij ją i wciskaj pasek w szczeliny; eksport zapyta, która pasowała.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: bez luzu</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: o %2 węższa</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: o %2 szersza</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Mostki</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>Tyle krótkich przerw w cięciu trzyma każdą część w arkuszu; 0: brak</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Szerokość mostków</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Najazd cięcia</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Każde cięcie zaczyna się i kończy tak daleko obok linii, w odpadzie; 0: na linii</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>tnij raz</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Wspólne krawędzie</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>Części, które do siebie przylegają, gdy odstęp wynosi 0</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Która z ponumerowanych szczelin próbki pasowania najlepiej trzyma arkusz (do wycięcia: menu Plik lub pliki do warsztatu). Ustawia luz.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Pasująca szczelina</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>około %n min</numerusform>
            <numerusform>około %n min</numerusform>
            <numerusform>około %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>Wymiary</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Wymiar %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>Zmiana tej długości skaluje cały model</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Zmiana tej długości rozciąga „%1” między tymi miejscami</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Usuń ten wymiar</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Otwórz model</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Wstaw model</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Importuj rysunek</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Dodaj podkład</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>Nic nie wstawiono: %1 nie ma płytek.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Zapisz model</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Niezapisane zmiany</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Zapisać zmiany w %1?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Bez zapisania przepadną.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Nie zapisuj</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Przywróć zapisany</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 jest w zapisanej postaci. Cofnij przywraca zmiany.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Otwieranie %1…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Wybierz inny plik</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Usuń z listy</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Zapisywanie %1…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Zapisz gdzie indziej…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Zapisano w %1.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Zmieniono na dysku</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>Plik %1 zmienił inny program.</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>Po nadpisaniu te zmiany przepadną.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Zapisz jako…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Nadpisz</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>bez nazwy</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Rysowanie</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Symetria lokalna</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Odbija kontur względem szczeliny, gdy jest rysowany po jednej jej stronie. Shift podczas rysowania działa odwrotnie.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Odbijaj pierwszą</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Odbija też pierwszą płytkę, względem pionu przez jej początek</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>Ścinaj przy podłożu</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Ścina równo z podłożem: pomija to, co narysowano poniżej</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Przyciąganie</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>Przyciąga do punktów, linii pomocniczych, podłoża i kratki</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Widok obraca się o</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>Przy 90° patrzy się wprost na nową płaszczyznę; przy mniejszym kącie widać też płytkę, od której się zaczęło</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Czas obrotu</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Jak długo widok obraca się do płaszczyzny nowej płytki</translation>
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
        <translation>Otwór podczas rysowania</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Nowy kontur podczas rysowania</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>Nowa płytka podczas rysowania</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>Teraz jej kontur</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Szczelina</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Na</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>Jej własna szczelina</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Odcinki krzywej</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>wypusty</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>zamknięta</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>otwarta w górę, głębokość %1</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>otwarta w dół, głębokość %1</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>otwarta na bok, głębokość %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Nie odbito.&lt;/b&gt; Połowy nie spotkałyby się przy szczelinie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Nie odbito.&lt;/b&gt; Rysunek jest po jednej stronie osi: %1 z jednej, %2 z drugiej. Symetria jest wyłączona albo naciśnięto Shift.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;Odbito.&lt;/b&gt; Rysunek jest po jednej stronie osi: %1 z jednej, %2 z drugiej. Przekrocz ją o co najmniej %3, aby narysować obie strony samodzielnie.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Nowa płytka</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Podkład</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Prowadzi</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Na prowadnicy</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1% pociągnięcia</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Największa odległość</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Za wartością może podążać tylko jedna liczba naraz.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Ta liczba nie może podążać za wartością.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Brak. Kliknij jedną płytkę, aby ją pominąć lub odłączyć.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Pokaż znowu</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nr %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, pominięta</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1, odłączona</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>Eksport plików do cięcia</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Potem otwórz folder</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Poszycie: %1</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 jako bryły</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 · %2 · %3 cięcia</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Obliczanie…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Eksportuj mimo to</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksportuj</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Rozkładanie…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Zmień…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 i kolejne w folderze %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 w folderze %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Zastępuje %1 w %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>domowym</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Arkusz %1 z %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Lista części</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Poprzedni arkusz (Page Up)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Następny arkusz (Page Down)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>Pokaż cały arkusz</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Poszycie nie ma arkuszy: plik zawiera kształt, który zarysowują płytki, jako powierzchnię na ich konturach.</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>Bryły nie mają arkuszy: plik zawiera model tak, jak stoi, w naturalnej wielkości, ze szczelinami.</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Arkusz %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Nie ma czego ciąć.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Obliczanie…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Wykorzystanie: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Rozkładanie części na arkuszach…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>Jaki materiał?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Zmierz ponownie</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Zmierzona grubość</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Zmierz suwmiarką arkusz, z którego będziesz ciąć: szczeliny zostaną do niego dopasowane.</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>Jaki arkusz?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Szerokość arkusza</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Wysokość arkusza</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, grubość %2</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Własny rozmiar</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>Która maszyna?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Kolory, warstwy, prędkości i G-code, jakie przyjmuje ta maszyna i jej program, oraz ile zabiera z każdego materiału</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, zmierzono %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>Tyle zmierzono</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>%n resztka jest zużywana najpierw.</numerusform>
            <numerusform>%n resztki są zużywane najpierw.</numerusform>
            <numerusform>%n resztek jest zużywanych najpierw.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Dowolny laser</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Żadna część nie leży na resztce.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>%1 z %n resztki zużywane najpierw.</numerusform>
            <numerusform>%1 z %n resztek zużywane najpierw.</numerusform>
            <numerusform>%1 z %n resztek zużywane najpierw.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2 razy</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>Nie da się wyciąć</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Sprawdzanie…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Nie ma na co uważać.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Arkusz materiału %1 nie ma miejsca między marginesami %2.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>Rzaz materiału %1 wynosi 0: szczeliny wyjdą szersze, a części mniejsze o to, co zabiera maszyna.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>Arkusze są większe niż stół maszyny %1: %2. Wybierz mniejsze.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Pasowanie</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Szerokość rzazu (pełna)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Luz szczelin</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Szczelina na rysunku</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Układ</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Odstęp</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Margines przy krawędzi</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Obracanie</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Ćwierćobroty dla arkusza ze słojami</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm, pod arkuszami</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Pasek pomiarowy</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Narysowany obok arkuszy, bez cięcia: zmierz go na maszynie, aby sprawdzić rozmiar</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cięcia</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Dowolny kąt</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Ćwierćobroty</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Półobroty</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Jak narysowano</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Pamiętane dla tego materiału i wybranej maszyny</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>kolor dla każdego połączenia</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Numery połączeń</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>Obie części połączenia mają jego numer w tym samym kolorze: na papier i dla maszyn, którym mówi się, co robić z każdym kolorem</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>Nie masz pewności? Najpierw wytnij próbkę pasowania…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>Szczeliny nic nie zostawiają z „%1”. Nie zostanie wycięte.</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 nie mieści się na arkuszu. Leży na arkuszu własnego rozmiaru.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>Za mało szerokości na numer: %1.</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 ma otwór lub wcięcie węższe niż rzaz, które nie zostanie wycięte.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>Brak miejsca na numery wszystkich połączeń: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n część</numerusform>
            <numerusform>%n części</numerusform>
            <numerusform>%n części</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n arkusz</numerusform>
            <numerusform>%n arkusze</numerusform>
            <numerusform>%n arkuszy</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Eksportowanie %1…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>od %1 do %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>Wyeksportowano %1 (%2) do %3.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>Wyeksportowano %1 (%2) do %3; szczeliny są narysowane na szerokość %4.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>Wyeksportowano %1 (%2) do %3; szczeliny są narysowane na szerokość %4 (%5 − rzaz %6).</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>Wyeksportowano bryły (%1) do %2.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Wyeksportowano poszycie do %1; %n miejsce zostaje otwarte.</numerusform>
            <numerusform>Wyeksportowano poszycie do %1; %n miejsca zostają otwarte.</numerusform>
            <numerusform>Wyeksportowano poszycie do %1; %n miejsc zostaje otwartych.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Wyeksportowano poszycie do %1.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiały…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Eksportuj gdzie indziej…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Są jeszcze arkusze z wcześniejszego eksportu: %1.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>Nie wyeksportowano: pliki, które tam są, zostają.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>Potrzeba o %n arkusz materiału %1 więcej, niż jest.</numerusform>
            <numerusform>Potrzeba o %n arkusze materiału %1 więcej, niż jest.</numerusform>
            <numerusform>Potrzeba o %n arkuszy materiału %1 więcej, niż jest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Brakuje liczby.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>Nie da się tu odczytać „%1”.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Po „%1” czegoś brakuje.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Nawias nie jest zamknięty.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>Jest o jeden nawias zamykający za dużo.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>Przez 0 nie da się dzielić.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Nie ma wartości o nazwie „%1”.</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>To nie jest długość; pomnóż długość przez zwykłą liczbę.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>To nie jest masa; pomnóż masę przez zwykłą liczbę.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>„t” to grubość materiału; tutaj nie ma jednego materiału.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>wiersz %1</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 i %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>Nic nie otwarto: nie podano pliku.</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 nie jest modelem. FlatFitFab otwiera %2.</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>Nie można otworzyć %1: tego pliku nie ma już w %2. Nic nie zmieniono.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>Nie można otworzyć %1: %2. Nic nie zmieniono.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>Nie można otworzyć %1: %2 (%3). Nic nie zmieniono.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>Plik na dysku jest nadal stary.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nic nie zapisano.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>folder %1 nie istnieje</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>Nie wyeksportowano: %1. %2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>Nie można zapisać %1: %2. %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>Staje się taki po przesunięciu któregoś z jego punktów</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Środek, we współrzędnych płytki</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Obrót o</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Otwór %1</translation>
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
        <translation>Dowolny kształt</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>Plik do cięcia</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Papier lub obraz</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Bryły do druku lub renderu</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Lista części</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Wszystko do warsztatu</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>Jaki plik?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Do czego?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Osobny plik na arkusz</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Odrysuj</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Gdzie leży</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Podłoże</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Kładzie na podłożu</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Przód</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Stawia pionowo, widziane z przodu</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Bok</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Stawia pionowo, widziane z prawej</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Płytka</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Kładzie na zaznaczonej płytce i porusza się razem z nią</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Odwróć</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Jak widziane od tyłu</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Wyrównaj dwa</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>Dwa ostatnie obrazy jako przód i bok tej samej rzeczy: tej samej wysokości i nad tym samym miejscem</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Próg</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>Jak ciemne musi być, aby zostało odrysowane</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Wygładzanie</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>Jak bardzo zaokrąglają się narożniki</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Obrysy</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Utwórz płytki</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Płytki z jego obrysów, na jego płaszczyźnie</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Wytnij otwory</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Otwory w płytce, na której leży lub która jest zaznaczona</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Graweruj</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Linie na płytce, na której leży lub która jest zaznaczona</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: za dużo na płytki</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>rozsuwa się, %1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n połączenie rozsuwa się, do %1&#x202f;N</numerusform>
            <numerusform>%n połączenia rozsuwają się, do %1&#x202f;N</numerusform>
            <numerusform>%n połączeń rozsuwa się, do %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modele (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Rysunki (%1)</translation>
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
        <translation>W prawo</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>W górę</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Na zewnątrz</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Copy: %1</source>
        <translation>Kopia: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>Klawisze</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Strony</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>Zapisz klawisze jako stronę</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Dokumenty PDF (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>Klawisze FlatFitFab</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>Nie można zapisać %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Wszystkie kroki; wybranie któregoś wraca do niego.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Tu pojawi się każdy krok; do każdego można wrócić.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>Z powrotem na początku. Kliknij późniejszy krok, aby go ponowić.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>Model jest taki, jak po „%1”.</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Po otwarciu</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Nowy model</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Tu zapisano</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Delete usuwa płytkę; przeciąganie albo Alt ze strzałką zmienia kolejność.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (usunięta)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wybierz…</translation>
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
        <translation>Utworzona przez operację</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Tworzy ją</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Kopia</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>Pomiń tę płytkę</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Odłącz</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>Zamienia tę płytkę w narysowaną; pozostałe nadal tworzy operacja</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Powstała z</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>Zmiana jednej z nich dotyczy wszystkich</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>Przerysuj ją; wszystko, co z niej powstało, zmieni się razem z nią</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Połączenie</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Szczeliny</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Przywróć ustawienia automatyczne</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Płytki</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>Otwarcie</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Odwróć szczeliny</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Szczelina</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kąt</translation>
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
        <translation>Punkt styku</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>wypust, szerokość %1</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>zamknięta, długość %1, szerokość %2</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>głębokość %1, szerokość %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 i %2 się przenikają.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Przytnij „%1”</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Punkt styku %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>Szczelina „%1” zajmuje taką część głębokości, szczelina „%2” resztę</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Ustawiono ręcznie; automatycznie jest 50%. %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Płytki: %1 i %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Ustawiono ręcznie; można przywrócić ustawienie automatyczne</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1: otwarcie</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>Strona, w którą otwiera się szczelina „%1”; szczelina „%2” otwiera się w przeciwną</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>W „%1”</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Rodzaj, kierunek i punkty styku znowu wybiera program</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>W tym połączeniu nic nie ustawiono ręcznie</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>Zaznacz połączenie z „%1”</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Jeszcze brak</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>nakładka krzyżowa</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>długa nakładka krzyżowa</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>gniazdo</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>wypusty</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>bez połączenia</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>Nakładka krzyżowa</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>Długa nakładka krzyżowa</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Gniazdo</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Wypusty</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brak</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>Luz ich materiału nie zostawia szczelinie żadnej szerokości</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>Szczeliny nie mogą otwierać się na zewnątrz: przeszkadza otwór</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>W jednym miejscu dałoby się je wsunąć tylko w jedną stronę, w innym tylko w drugą</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Nic by ich nie trzymało: tam, gdzie zaczynałyby się szczeliny, są otwory</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>Jedna płytka wystaje poza drugą, w którąkolwiek stronę by je wsuwać</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Żadna płytka nie wystaje poza drugą</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Spotykają się w więcej niż jednym miejscu</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Żadna płytka nie przejdzie przez zamkniętą szczelinę w drugiej</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>Jedna płytka tylko kończy się na drugiej</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Żadna płytka nie kończy się na powierzchni drugiej</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>Nie ma miejsca na wypusty i ich szczeliny</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Spotykają się pod kątem mniejszym niż 30°</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>W prawo</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>W lewo</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>W górę</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>W dół</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Do przodu</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Do tyłu</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Naciśnij klawisze</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>Klawisze</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>Zapisz je jako stronę do druku…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>W widoku</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>Narysować pierwszą płytkę</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>przeciągnąć na środku</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Narysować płytkę w poprzek innej</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>przeciągnąć na zewnątrz</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Obrócić widok</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>przeciągnąć obok modelu</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Przybliżyć</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>kółko</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Przesunąć widok</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>przeciągnąć środkowym</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Zaznaczyć</translation>
    </message>
    <message>
        <source>click</source>
        <translation>kliknąć</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Zaznaczyć grupę</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>przeciągnąć z Shift</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Zobaczyć, co można z tym zrobić</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>prawy przycisk</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Dodać punkt</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>dwa razy kliknąć kontur</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Rysować bez przyciągania</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>przytrzymać Ctrl</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Układ</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Odstęp</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margines</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Arkusz</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Obracanie</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Części w otworach</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>Małe części mogą leżeć w otworach dużych</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>Milimetry</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centymetry</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Cale</translation>
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
        <translation>Część</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteka</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Dodaj zaznaczenie</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>Umieszcza zaznaczenie w bibliotece; bez zaznaczenia cały model</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Folder…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>Wybierz folder, z którego modele są tu pokazane</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>Tu pojawiają się przechowywane części: zaznacz kilka płytek i kliknij „Dodaj zaznaczenie”.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Folder biblioteki</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>Nic nie dodano: nic jeszcze nie narysowano.</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>Nie można utworzyć folderu biblioteki %1.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 jest teraz w bibliotece.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 jest w koszu.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>Nie można przenieść do kosza: %1.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Dodaj do modelu</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>Przenieś do kosza</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadPage</name>
    <message>
        <source>Weight</source>
        <translation>Ciężar</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Nacisk</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Gdzie działa</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Przedmiot</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Zwykły ciężar</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>Także w kg, oz lub lb: 1,5 kg, 2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Woda w środku</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Środek masy</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>Wysokość nad miejscem: im wyżej, tym łatwiej model się wywraca</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Siła</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N to mniej więcej tyle, ile waży 1 kg</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Kierunek X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Kierunek Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Kierunek Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Na</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>W płaszczyźnie płytki, od początku jej układu współrzędnych</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Miejsce X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Miejsce Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Rozłożenie</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>W punkcie</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>Na powierzchni</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Wzdłuż krawędzi</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Wisi</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>Także na kopiach</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Kopie płytki, które tworzą operacje, też dźwigają po jednym</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Ciężary i naciski</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 zmienia nazwę, Del usuwa.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Ciężary</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Naciski</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Nacisk</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Ciężar</translation>
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
        <translation>Podkład</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Dociągany</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Wygina podkład do płaszczyzny tej płytki, aby prowadnice innych zgadzały się z tym, co narysowano</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>Z odległości do</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Pasek narzędzi</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Powtarzanie</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Powtarza płytki i tworzy przejścia między nimi</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>Nie można pokazać modelu: sterownik grafiki nie obsługuje OpenGL 3.3. Może pomóc nowszy sterownik.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>Na tym ekranie nie można pokazać modelu.</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Zacznij nowy model, kontynuuj któryś albo obejrzyj przykład.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Odzyskano: %n niezapisany model</numerusform>
            <numerusform>Odzyskano: %n niezapisane modele</numerusform>
            <numerusform>Odzyskano: %n niezapisanych modeli</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Pokaż je</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Odzyskano: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Pokaż folder</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Ten model jest tu do dopasowania. „Edytuj projekt” przywraca wszystko.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Pomoc: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Zaproponuj płytki</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Ile</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Zaproponuj</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Znajduje płytki, które oddają jego kształt, trzymają się nawzajem i stoją</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Jeszcze jedna</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Płytka, która mieści się między istniejącymi</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Inne</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>Inne płytki zamiast ostatnich</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Ścianki</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Ściany</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Zbuduj ze ścianek</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>Buduje to z płaskich arkuszy z wczepami na krawędziach. Siatka jest najpierw upraszczana do tylu ścian; te, które razem leżą płasko, są jednym arkuszem.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Rozwiń</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>Rozkłada na płasko, do wycięcia z kartonu w jednym lub kilku kawałkach i zgięcia wzdłuż naciętych linii. Krawędzie do połączenia mają ten sam numer.</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>Znaki</translation>
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
        <translation>Obrót o</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Znak %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Grawerowany</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Nacinany</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Usuń ten znak</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Wysokość liter</translation>
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
        <translation>Wczytywanie %1…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>Plik %1 jest za duży na model, więc nadano mu rozmiar %2. Rozmiar jest w panelu Podkłady.</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>Plik %1 nie podaje jednostki, więc nadano mu rozmiar %2. Rozmiar jest w panelu Podkłady.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Siatki, obrazy i rysunki (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Wklejony obraz</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>W skali %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Komunikat</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Szczegóły</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Zamknij ten komunikat</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>I jeszcze %n.</numerusform>
            <numerusform>I jeszcze %n.</numerusform>
            <numerusform>I jeszcze %n.</numerusform>
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
        <translation>Jednostki</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>nic jeszcze nie narysowano</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Nowe płytki</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Materiał płytek, które będą teraz rysowane</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Edytuj materiał</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>Ruch</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>Pokazuje z przesadą, gdzie model się ugina lub obluzowuje. Nic się nie zmienia.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Odtwórz</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>Animacje są ograniczone: użyj suwaka</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Wstrzymaj</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>Nie wiadomo, jak się porusza.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>Włącz „Płytki się uginają”, aby zobaczyć ugięcie.</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Pokazano, jak zaczyna się rozpadać.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Ugina się o %1, pokazano %2 razy większe.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Ugina się o %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>Nazwane wartości</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Nazwa to słowo z liter i cyfr, inne niż „t” i jednostki.</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Usuń tę wartość</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Płytka %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>różne</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>Co najmniej %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>Najwyżej %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Resztka</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Arkusz innego rozmiaru, zużywany przed całymi</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>Z rysunku…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>To, co zostało z arkusza, jako największy obrys pliku SVG w prawdziwej wielkości, z otworami</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Szerokość resztki</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Wysokość resztki</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Ile takich resztek</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Usuń tę resztkę</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, z rysunku</translation>
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
        <translation>Wybierz inną</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Pozwól na więcej</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Zostaw tak</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wybierz</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Wyjątki</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Utrwal</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Zamienia to, co tworzy, w narysowane płytki; samej operacji potem już nie ma</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>Usuwa ją i wszystko, co tworzy</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Dane wejściowe</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wybierz</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Pozwól na więcej</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Operacje, po kolei</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 zmienia nazwę, Spacja ukrywa i pokazuje, Alt ze strzałką zmienia kolejność.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wył.</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Ukryta: pokaż</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ukryj</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Struktura</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Filtruj po nazwie lub materiale</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Płytki</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 zmienia nazwę, Spacja ukrywa i pokazuje.</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>Tu pojawiają się rysowane płytki.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Zmień nazwę</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, w trakcie rysowania</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Zablokowana: odblokuj</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>Zablokuj</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Ukryta: pokaż</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ukryj</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Narysuj tu kształt z wciśniętym lewym przyciskiem.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1 i jeszcze %n tutaj</numerusform>
            <numerusform>%1 i jeszcze %n tutaj</numerusform>
            <numerusform>%1 i jeszcze %n tutaj</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Obliczanie szczelin…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 od ostatniego punktu</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>Odbite względem szczeliny</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>Odbite względem pionu</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Ścięte równo z podłożem</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Podłoże %1 poniżej tej krawędzi</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Szczelina %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Szczelina %1, %2</translation>
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
        <translation>Jak wynika z płytek</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Ustawiono ręcznie</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Lista części</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Liczba</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>Fizyka</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Wyświetlanie</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Linie naprężeń</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Pokaż od</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Część wytrzymałości arkusza; mniejszych wartości nie widać</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>elementy skończone</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Płytki się uginają</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Tam, gdzie połączenia dzielą się obciążeniem, sztywność płytek decyduje, ile które przenosi. To chwilę trwa.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Mapa nośności</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Koloruje zaznaczoną płytkę według masy, jaką utrzyma każde jej miejsce, oprócz tego, co już jest na modelu. To chwilę trwa.</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Najsłabsze miejsca</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Obciążenia</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Połóż na modelu ciężar, aby zobaczyć, ile utrzyma.</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Ciężar własny</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Na podłożu</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Dodaj ciężar</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Dodaj nacisk</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Jak surowo</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Współczynnik bezpieczeństwa</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>Ile razy większe obciążenie musi unieść model, aby uznać, że utrzyma</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Współczynnik karbu, najwyżej</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>Wzrost naprężeń w wewnętrznych narożnikach wynika z długości przewężenia, aż do tego współczynnika; szczeliny z zaokrąglonym końcem wymagają mniej</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>miesiącami</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>Obciążenie trwa</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Materiał utrzyma wtedy mniej, tyle, ile dla niego ustawiono: pleksi tylko jedną czwartą</translation>
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
        <translation>Usuń ten nacisk</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Usuń ten ciężar</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>obliczanie… %1%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>obliczanie…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zatrzymano</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>nie udało się obliczyć</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>zaznaczona płytka</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>zaznacz płytkę</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Narysuj płytkę, aby zobaczyć, ile utrzyma.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Nie udało się obliczyć, czy utrzyma.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Starsze niż rysunek, obliczanie…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Nie stoi; naprężeń nie pokazano.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Połączenie się rozsuwa; naprężeń nie pokazano.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Wytrzymałość nieznana: któryś materiał jej nie ma. Podaj ją w oknie Materiały.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>Aktualne. Połączenia mogą dzielić obciążenie na wiele sposobów; liczy się najgorszy.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>Aktualne. Wszystkie siły się równoważą.</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Ugina się o %2.</translation>
    </message>
    <message>
        <source>%1, %2: %3&#x202f;%</source>
        <extracomment>the name of a section, a place in it such as &quot;at its neck&quot;, a number of percent</extracomment>
        <translation>%1, %2: %3%</translation>
    </message>
</context>
<context>
    <name>fff::ui::PlaceGroup</name>
    <message>
        <source>across its slit</source>
        <translation>względem szczeliny</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>względem pionu</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>względem poziomu</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Położenie</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Wolna</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>Nie przesuwa się z płytką, na której jest, i nie zachowuje do niej kąta</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Zablokowana</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Zostaje, jak jest, chyba że przesunie się płytka, na której jest</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symetryczna</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>Zmiany punktów jednej połowy dotyczą też drugiej</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Na</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niczym</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Kliknij inną płytkę, aby ją na niej umieścić</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>Nie na innej płytce</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Kąt do niej</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Podąża</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>proporcjonalnie</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>za lewym końcem</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>za prawym końcem</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>za dolnym końcem</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>za górnym końcem</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Jak jej miejsce podąża, gdy wartość rozciąga płytkę, na której jest: o tyle, o ile tamta jest tam rozciągana, albo w swojej odległości od końca</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Pozycja</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X środka</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y środka</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z środka</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X kierunku, w który jest zwrócona, długość 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y kierunku, w który jest zwrócona, długość 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z kierunku, w który jest zwrócona, długość 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
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
        <translation>Uchwyt przed</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Kąt przed</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Uchwyt po</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Kąt po</translation>
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
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Narożnik</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gładki</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symetryczny</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>Zestaw</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>zmieniony</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nazwa zestawu</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, cztery półki…</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Zachowuje obecne ustawienia jako zestaw</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Usuń ten zestaw</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Zachowaj jako zestaw</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Nadaje obecnym ustawieniom nazwę, na przykład A5, aby móc do nich wrócić</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 na zewnątrz</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 wewnątrz</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 za wysoko</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Właściwości</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>Jeszcze %n w panelu Kontrola.</numerusform>
            <numerusform>Jeszcze %n w panelu Kontrola.</numerusform>
            <numerusform>Jeszcze %n w panelu Kontrola.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Włączona</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Wyłączona nic nie tworzy, ale zachowuje ustawienia</translation>
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
        <translation>%1 na „%2”</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nic nie zaznaczono</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Zmiany dotyczą wszystkich</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Przenikają się</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automatycznie</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · ustawiono ręcznie</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n połączenie</numerusform>
            <numerusform>%n połączenia</numerusform>
            <numerusform>%n połączeń</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Tworzy ją „%1” · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Płytka · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Płytka · na „%1” · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · wyłączona</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · nic nie tworzy</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · aktualne</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Otwórz ostatnie</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (brak pliku)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Wyczyść tę listę</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Zapomina te nazwy; pliki zostają</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>Na co uważać</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Zamyka to okno i zaznacza to w modelu</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Zastąp pliki</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>Zastąpić %n istniejący plik?</numerusform>
            <numerusform>Zastąpić %n istniejące pliki?</numerusform>
            <numerusform>Zastąpić %n istniejących plików?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Zastąp</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>Zastąpić ten plik?</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>poziomo</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>Wzdłuż żebra od pierścienia do pierścienia</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>Wzdłuż żebra do dolnego pierścienia</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Łuk</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>w_bok</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>oś_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>oś_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Plecy</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Belka</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Belki</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>Żebro brzuszne</translation>
    </message>
    <message>
        <source>between</source>
        <translation>między</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Półka</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Półki</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>półki</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Tułów</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Gałąź</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>wielka_litera</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Komórki</translation>
    </message>
    <message>
        <source>column</source>
        <translation>kolumna</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolumny</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>kolumny</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Podpórka</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>podpórka</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Zwieńczenie</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Sztućce</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>głębokość</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>średnica</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>rozstaw</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Przegródka</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Przegródki</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Uszy</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Dalsza podstawa</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Dalszy tancerz</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Dalszy tancerz, pochylony</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Dalsi tancerze</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Jodła</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Jodła w poprzek</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Dno</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Stopka</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Przednie łapy</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Widelce i łyżeczki</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Cztery półki</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>Od osi do osi, w poziomie</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>Od osi do osi, z odrobiną luzu</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>Od ścianki do ścianki</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Przód</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Przednia stopka</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Przednie łapy</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Przednia poprzeczka</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Przednia fala</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Szklanka wody</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Uchwyt</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Głowa</translation>
    </message>
    <message>
        <source>height</source>
        <translation>wysokość</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Wysokość wielkich liter; długie imię musi być mniejsze</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Wysokość podpórek</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Wysokość osi zębnika</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Wysokość osi dużego koła</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Tylna stopka</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Tylne łapy</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Tylna fala</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Biodro</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Rogi</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>O ile w bok od swojego miejsca na dole żebro dochodzi do górnego pierścienia</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>Jak mocno pochyla się każde żebro</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>O ile niżej leży zębnik, patrząc od dużego koła</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Szerokość tabliczki liczona w wysokościach wielkiej litery</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Jej szerokość</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Słoiki</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Ostatnie żebro</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Lewa stopka</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Lewy liść</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Lewy bok</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Lewa listwa</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Lewe skrzydło</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Noga</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Nogi</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>nogi</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>litery</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Długa stopka</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>dolny</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Dolny pierścień</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Dolna listwa</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Środek</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Środkowa podstawa</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Środkowy tancerz</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Środkowy tancerz, pochylony</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Środkowi tancerze</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Środkowe żebro</translation>
    </message>
    <message>
        <source>module</source>
        <translation>moduł</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Kubek</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Pysk</translation>
    </message>
    <message>
        <source>name</source>
        <translation>imię</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Tabliczka z imieniem</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Bliższa podstawa</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Bliższy tancerz</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Bliższy tancerz, pochylony</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Bliżsi tancerze</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Szyja</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>Żebra, mierzona wzdłuż niego</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>Półek, od końca do końca</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Szuflady, wewnątrz</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Szklanki</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>Najwyższej ścianki</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Zębnika, od ustawienia wrębem do dużego koła</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Zębnika, tak samo</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>Boków</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>Boków; zwieńczenie sięga wyżej</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>Dużego koła</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>Dużego koła, do dna wrębów</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>Dużego koła, do wierzchołków zębów</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Druga stopka</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Drugi filar</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Druga poręcz</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Drugi bok</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Druga podwalina</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Drugi palec</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Długopisy</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>faza</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>Filar</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Zębnik</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>zębnik</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Zęby zębnika</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>promień_zębnika</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>dno_zębnika</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>zębnik_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Płyta</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>tabliczka</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Płyty</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>promień</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Poręcz</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Promień płetwy</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Promienie płetwy</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Tylne żebro</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>reszta</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Żebro</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Żebra</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>żebra</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Prawa stopka</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Prawy liść</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Prawy bok</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Prawa listwa</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Prawe skrzydło</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Pierścień</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Krąg otworów</translation>
    </message>
    <message>
        <source>root</source>
        <translation>dno</translation>
    </message>
    <message>
        <source>row</source>
        <translation>rząd</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rzędy</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>rzędy</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Śrubki</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Siedzisko</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Półka</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Bark</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Bok</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Boki</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Podwalina</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Wielkość zębów: średnica podzielona przez ich liczbę</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Plastry</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Mała szklanka</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Kręgosłup</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Łyżki i noże</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Gwiazda</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Słońce</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Ogon</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zęby</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>zęby</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Zęby zębnika</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>To samo bez całych zębów</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Trzy półki</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>nachylenie</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Kantówka</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>Kantówki</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>Palec</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Ząb</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Pień</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>Szklanka</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>obrót</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Gałązka</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>skręt</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Górny pierścień</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Górna listwa</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Kręgi szyi</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Kręgi ogona</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Ścianka</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Wieloryb</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>Ile zmieści się na arkuszu</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Duże koło</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Położenie zęba dużego koła</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Szeroki</translation>
    </message>
    <message>
        <source>width</source>
        <translation>szerokość</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>krotność</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Ryba</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Jamnik</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Jodła</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Abażur</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Krzesełko dla lalki</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Uchwyt na szklankę</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Przybornik na biurko</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Regał</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Wkład do szuflady</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Tabliczka z imieniem</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Podstawka pod szklankę</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Niedźwiedź z siatki</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Sowa z obrazów</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Jeż w plastrach</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Rybie ości</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinozaur</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Jelonek rogacz</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Rosnące drzewo</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Tancerze w dwóch pozach</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Kładka</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Koła zębate</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Wieloryb w komórkach</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Ludzik na sztućce</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Szklanka na trzech nogach</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Trzy cienkie nogi: za słabe</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Cztery cienkie nogi: za słabe</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Trzy grube nogi: ledwo</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Cztery grube nogi: bezpiecznie</translation>
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
        <translation>zacznij utwórz pusty stwórz</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>wczytaj importuj flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>dodaj scal dołącz połącz</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>zachowaj zapis</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>kopia zmień nazwę</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>wczytaj ponownie odrzuć</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>drukuj drukarka laser wycinarka cnc ploter svg dxf pdf gcode lightburn wykonaj wytnij produkcja</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>preferencje opcje konfiguracja ciemny jasny motyw język jednostki cale mysz nawigacja autozapis animacja</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>klawisze skróty klawiatura</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>wyjdź zamknij koniec</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf import</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf import grawerowanie</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj obraz zdjęcie fotografia odrysuj kalka wzór szablon tło</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>wstecz ups</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>znowu naprzód</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>schowek</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>kopiuj klonuj duplikuj</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>odwróć lustro lustrzane symetryczne</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>skasuj wymaż kosz</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>całość wszystkie</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>szukaj wyszukiwanie paleta</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoom powiększ wyśrodkuj centruj</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom powiększ skup</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>patrz prosto</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>ortogonalny izometryczny równoległy kamera</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>przezroczysty szkielet na wylot prześwietl</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>przekrój wnętrze połowa przetnij</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>powierzchnia skorupa powłoka skóra</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>solo samo</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>odkryj widoczne</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>niewidoczne</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>kratka siatka podłoga ziemia</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>udostępnij przekaż dostosuj konfiguruj uczeń klasa zmień suwaki zablokowany pełne okno</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>maksymalizuj powiększ</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>paski boczne</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>układ domyślny</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>lustro odbicie połowa</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>ziemia podłoga stopki podstawa</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>magnes wyrównaj prowadnica</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>wielokąt linia krzywa bezier ścieżka</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>koło okrąg kwadrat prostokąt wielokąt gwiazda kształt</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>grawer tekst litery napis etykieta</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>przesuń obróć skaluj rozmiar</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>dziura okno wycięcie</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>zastąp</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>szyk wzór powtórz szereg żebra</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>obrót dookoła wokół</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>morfing pomiędzy przekształć</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>drzewo rozgałęzienie</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>kratownica krata wafel siatka</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>szprychy koło zębatka biegunowy</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>obróć biegunowy szyk wzór</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>wzór powtórz kopie</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>kratownica warstwy przekroje stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>zamień rozbij zastosuj</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>błąd ostrzeżenie kłopot</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>składanie montaż instrukcja animacja odtwórz</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>wytrzymałość złamanie symulacja fizyka mes</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>obciążenie masa siła odważnik</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>siła obciążenie pchnij</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>materiał grubość sklejka pleksi akryl rzaz</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>próbka test rzaz luz szczeliny grzebień</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>nesting rozkrój układ rozmieść</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>długość odległość rozmiar wymiar</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>skala rozmiar wielkość</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>podręcznik samouczek dokumentacja przewodnik</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>powitanie przykłady</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>wersja licencja</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Połączenia</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Edytuj materiał</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Grubość materiału: zmieni się we wszystkich płytkach z tego materiału</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Jak wszystkie inne</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Obracanie</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Jak wolno obracać jej części na arkuszu: część zgodna ze słojami leży jak narysowano albo obrócona o pół obrotu</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Inna długość rozciąga kontur względem szczeliny albo środka</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Otwory</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
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
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Grupy ustawień</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Ogólne</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Pliki</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Klawiatura</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Jednostki</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Milimetry (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centymetry (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Cale (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>Co widać i co się wpisuje. Pliki zawsze zawierają milimetry.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Kolory</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Jak w systemie</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Jasne</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Ciemne</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Wysoki kontrast</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Działa po ponownym uruchomieniu.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Pokazuj stronę startową przy uruchamianiu</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Czas obrotu</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Jak długo widok obraca się podczas rysowania do nowej płaszczyzny. Przy 0 przeskakuje.</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Widok obraca się o</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>Przy 90° patrzy się wprost na nową płaszczyznę. Przy mniejszym kącie widać też płytkę, od której się zaczęło.</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>Przyciągaj linie do podkładu z</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Przyciski myszy jak w</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Które przyciski obracają, przesuwają i przybliżają widok. Ctrl z lewym przyciskiem zawsze go obraca, Spacja z lewym przyciskiem go przesuwa.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Animacje</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Zawsze</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>Jak najmniej</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Przy „Jak najmniej” widok przeskakuje, zamiast się obracać.</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Kolory naprężeń dla daltonistów</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>Od jasnego do ciemnego zamiast od niebieskiego do czerwonego. Przy wysokim kontraście zawsze.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Ostrzegaj o kątach poniżej</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Im bardziej płasko spotykają się dwie płytki, tym szersze muszą być ich szczeliny.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Pomijaj przenikanie poniżej</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Mniejsze przenikanie nie jest problemem.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Szukaj kolejności składania przez</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>W tle, po każdej zmianie. Wydłuż czas, jeśli kontrola nie znajduje kolejności.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Współczynnik bezpieczeństwa</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>Ile razy większe obciążenie musi unieść model, aby uznać go za dość mocny.</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Współczynnik karbu, najwyżej</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>Ile razy większe przyjmuje się naprężenie w wewnętrznych narożnikach.</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>Obciążenia trwają miesiącami</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Kopia niezapisanej pracy co</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Po awarii lub zaniku prądu odzyskasz ją, nawet jeśli nie było zapisu. Twój plik pozostaje nietknięty.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Przy zapisie zachowuj poprzednią wersję</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Proste okno</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Do rysowania, sprawdzania i eksportu; reszta nie przeszkadza.</translation>
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
        <translation>Laser K40</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>Cała płyta sklejki</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>Na arkuszu</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Arkusz</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Pozycja X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Obrót o</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>zostaje na miejscu</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Przypięta</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P przypina i odpina zaznaczoną część na arkuszach</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>za duża na arkusz</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, jej pierwsza część</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm, do sprawdzenia rozmiaru</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Arkusz tak, jak zostanie wycięty</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Plus i minus przybliżają i oddalają, strzałki przesuwają, Home pokazuje całość.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>Resztka %1 zostaje cała</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Arkusze</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Szybko</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Dobrze</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Najlepiej</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Jak dobrze rozłożyć części</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Szybko rozkłada wszystkie części od nowa. Dobrze zajmuje około dziesięciu sekund. Najlepiej trwa, dopóki się nie zatrzyma.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Podziel na komórki</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Odepnij wszystkie</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Narysuj płytkę, a będzie tu leżeć, gotowa do wycięcia.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Rozkładanie…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Ponowne rozkładanie…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>Dla %n przypiętej części nie było miejsca tam, gdzie leżała.</numerusform>
            <numerusform>Dla %n przypiętych części nie było miejsca tam, gdzie leżały.</numerusform>
            <numerusform>Dla %n przypiętych części nie było miejsca tam, gdzie leżały.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 nie mieści się na swoim arkuszu.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 i jeszcze %n płytka nie mieszczą się na swoich arkuszach.</numerusform>
            <numerusform>%1 i jeszcze %n płytki nie mieszczą się na swoich arkuszach.</numerusform>
            <numerusform>%1 i jeszcze %n płytek nie mieszczą się na swoich arkuszach.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Dodaj resztkę</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>o %n arkusz więcej, niż jest</numerusform>
            <numerusform>o %n arkusze więcej, niż jest</numerusform>
            <numerusform>o %n arkuszy więcej, niż jest</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · %2 cięcia</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>zachowuje najlepszy układ dotąd, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Rozkładanie… wykorzystanie %1%</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 · %2 · wykorzystanie %3% · %4 cięcia</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Arkusze tak, jak zostaną wycięte</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Page Up i Page Down przechodzą od części do części, strzałki przesuwają część o 1 mm, R ją obraca, P przypina. Plus i minus przybliżają i oddalają, Home pokazuje wszystkie arkusze.</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · obrót o %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>Nie ma na to miejsca.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>Nie wolno jej obrócić o tak mało.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Leży tak, jak narysowano.</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Arkusz %1 z %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>Za duże</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>słoje ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n część · wykorzystanie %1%</numerusform>
            <numerusform> · %n części · wykorzystanie %1%</numerusform>
            <numerusform> · %n części · wykorzystanie %1%</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Resztka, arkusz %1 z %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Przypięta: zostaje tam, gdzie leży. Kliknij, aby ją odpiąć.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Przeciągnij część w inne miejsce albo kliknij ją, aby ją zaznaczyć.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Kliknij, aby odpiąć &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt;: za duże na swój arkusz. Kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przeciągnij &lt;b&gt;%1&lt;/b&gt; w inne miejsce albo kliknij, aby zaznaczyć.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Przeciągnij &lt;b&gt;%1&lt;/b&gt; w inne miejsce. &lt;kbd&gt;R&lt;/kbd&gt; obraca, &lt;kbd&gt;P&lt;/kbd&gt; przypina.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtruj po nazwie lub klawiszach</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Brak klawiszy dla tego polecenia</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>Pierwotne klawisze tego polecenia</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Przywróć wszystkie</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>Pierwotne klawisze wszystkich poleceń</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>Użyj tutaj</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Polecenia i ich skróty</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Polecenie</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Skrót</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Działa</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>w widoku</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>wszędzie</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Wybierz polecenie</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Klawisze dla „%1”:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Zmieniono</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>Samo %1 przeszkadzałoby w pisaniu. Dodaj do tego Ctrl lub Alt; pojedyncze klawisze są dla poleceń działających w widoku.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 należy do „%2”.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Poszycie mocno by się tu wybrzuszyło: %1. Jak bardzo, pokaże jeszcze jedna płytka w poprzek.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Poszycie założyłoby się tu na siebie: %1.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Z konturów nie wynika, co jest między tymi płytkami: %1.</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Poszycie: obliczanie… %1%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Poszycie: obliczanie…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Poszycie: zatrzymano</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Poszycie: nie udało się obliczyć</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Poszycie</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Poszycie: nie ma czego pokryć</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Poszycie: kontury się nie krzyżują</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Kliknij, aby zatrzymać.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Poszycie wymaga płytek, które się krzyżują i kończą tam w tym samym miejscu.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n płat</numerusform>
            <numerusform>%n płaty</numerusform>
            <numerusform>%n płatów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; %n miejsce zostaje otwarte.</numerusform>
            <numerusform>%1; %n miejsca zostają otwarte.</numerusform>
            <numerusform>%1; %n miejsc zostaje otwartych.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Kliknij, aby znów zobaczyć same płytki.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Prosty</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Zaokrąglony</translation>
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
        <translation>Koniec szczeliny</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>Wewnętrzny koniec szczeliny. Laser tnie go prosto; okrągły frez nie sięga w narożniki. Zaokrąglony: okrągłe dno za prostym. Dogbone: łuk przez każdy narożnik. T-bone: łuk w każdej ściance; dno zostaje płaskie.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Narzędzie</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Średnica freza. Łuki są rysowane trochę większe, aby frez mógł je objechać.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Prosty koniec nie ma narzędzia. Do frezarki wybierz inny koniec szczeliny.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Fazka</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Ścięcie obu ścianek u wlotu szczeliny, pod kątem 45°, aby płytki łatwo się wsuwały. Zwykle od połowy do całej grubości; 0: brak.</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Garbki dociskowe</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Wysokość garbka na każdej ściance szczeliny, który dociska tkwiącą w niej płytkę. Musi być większa niż połowa luzu; 0: brak.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>płytka</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>płytka utworzona przez operację</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>na „%1”</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>zablokowana</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>ma problem</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>bez problemu</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Połączenie „%1” i „%2”</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, operacja</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 na „%2”</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>zaznaczono %n płytkę</numerusform>
            <numerusform>zaznaczono %n płytki</numerusform>
            <numerusform>zaznaczono %n płytek</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Strona startowa</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Narysuj własny model</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Otwórz…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Otwiera model, także z FlatFab</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Bez konta, nic nie opuszcza tego komputera.</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Pokazuj przy uruchamianiu</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Ostatnie</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Przykłady</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Odzyskano: %1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Pokaż folder</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>brak pliku</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Usuń z tej listy</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>Otwórz kopię</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Pierwszy model w 3 minuty</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Narysuj, sprawdź i wytnij model, krok po kroku</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>Co zrobi następny gest</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Liczba płytek</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Rozmiar modelu</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Masa modelu</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Jednostki</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Jednostka wszystkich długości</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>Cofnięto „%1”.</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>Cofnięto „%1”. &lt;kbd&gt;%2&lt;/kbd&gt; przywraca.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>Ponowiono „%1”.</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>Ponowiono „%1”. &lt;kbd&gt;%2&lt;/kbd&gt; cofa.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Kroki składania</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Eksportuj kroki…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Zamknij kroki (Esc)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Poprzedni krok (strzałka w lewo)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Odtwórz (Spacja)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Następny krok (strzałka w prawo)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>Rozsuwa części</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Rozsunięcie</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Wstrzymaj (Spacja)</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Zapisuje wszystkie kroki w PDF do druku, na stronie internetowej na telefony albo obraz każdego z nich</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Wszystkie kroki, do druku (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Obrazy, po jednym na krok (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Eksport kroków</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Eksportowanie %1…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>Nic nie zapisano: eksport anulowano.</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>Nie udało się wyeksportować kroków: na tym ekranie nie da się utworzyć obrazu.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n krok</numerusform>
            <numerusform>%n kroki</numerusform>
            <numerusform>%n kroków</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>Wyeksportowano %1 do %2.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>Wyeksportowano %1 do %2 … %3.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Eksportuj gdzie indziej…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Strona internetowa (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>Ta przeglądarka nie pokazuje modelu w 3D. Oto, co trzeba zrobić, krok po kroku.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>Nie ma obrazów: na ekranie komputera, który zapisał tę stronę, nie dało się utworzyć żadnego.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Przeciągnij, aby obrócić model, użyj dwóch palców lub kółka, aby go powiększyć, stuknij dwa razy, aby zobaczyć całość.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Odtwórz</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Gotowe</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Wstrzymaj</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Poprzedni krok</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Następny krok</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Części</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 część</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n część</numerusform>
            <numerusform>%n części</numerusform>
            <numerusform>%n części</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 arkusz</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n arkusz</numerusform>
            <numerusform>%n arkusze</numerusform>
            <numerusform>%n arkuszy</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 krok</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n krok</numerusform>
            <numerusform>%n kroki</numerusform>
            <numerusform>%n kroków</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Strona %1 z %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>Jak to złożyć</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, %2, %3.</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>Numery są wygrawerowane na częściach. Przy każdej szczelinie, za krótką kreską, jest numer jej połączenia, taki sam na obu częściach.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in %2.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;38 steps&quot;</extracomment>
        <translation>%1, %2.</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsView</name>
    <message>
        <source>The model has changed, so its steps are not shown.</source>
        <translation>Model się zmienił, więc jego kroków nie pokazano.</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>Na tym ekranie nie można pokazać kroków.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>Kroki nie zostaną pokazane.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>Trwa obliczanie kolejności składania; kroki pojawią się, gdy tylko będzie znana.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Nie można pokazać kroków: %1.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>Kolejność składania jest już znana; pokaże ją „Pokaż kroki”.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Nic tu jeszcze nie ma.&lt;/b&gt; Krok 1: %1</translation>
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
        <translation>Sklejka brzozowa</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Sklejka brzozowa 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Sklejka brzozowa 6,5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Sklejka brzozowa 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>Pleksi</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>Pleksi bezbarwna</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Pleksi czerwona</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Tektura falista B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Tektura falista C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Tektura falista E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Karton</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Lipa</translation>
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
        <translation>Użyj do nowych płytek: %1</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: grubość %2 → %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Materiał następnej płytki</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Materiał następnej płytki: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiały…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Arkusz</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Arkusz szer. × wys.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Gęstość</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nieznana</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 oznacza, że nieznana</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Cena arkusza</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Szerokość arkusza</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Wysokość arkusza</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Typowe arkusze</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Wytrzymałość</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Na rozciąganie</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Na zginanie</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Sztywność</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>zanim się złamie</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Ugina się</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Jak metal: powyżej tych wytrzymałości zostaje wygięte</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Utrzyma miesiącami</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Część wytrzymałości przy stałym obciążeniu: pleksi pełznie i pokrywa się rysami</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Cięcie</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Szerokość rzazu</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Luz szczelin</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Szczelina na rysunku</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Szczeliny</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 oznacza, że nie podano</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>Nie ma z tego żadnych płytek</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>brak: rzaz jest szerszy niż szczelina</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Grubość, luz i rzaz dwóch prostopadłych do siebie płytek z tego materiału</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Sprzedawane jako</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>Grubość, pod jaką kupuje się arkusz; zwykle nie jest dokładnie taka</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>suwmiarką, przeze mnie</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzone</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>Eksport pyta raz, jak grube są arkusze, które będziesz ciąć</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>ile potrzeba</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 oznacza tyle, ile potrzeba</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Ile ich jest</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Zużywane najpierw</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Resztka z rysunku</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Rysunki (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Według maszyny</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Pamiętane tam, gdzie wpisano rzaz, gdy ta maszyna była wybrana w eksporcie</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Rozmiar i liczba</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Materiały tego modelu</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Dodaj</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Dodaje materiał z listy gotowych</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Powiel</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Dodaje materiał z tymi samymi liczbami</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Zapisuje ten materiał w pliku, dla innych modeli i innych osób</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Zapisz materiał w pliku</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Usuń materiał</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n płytka</numerusform>
            <numerusform>%n płytki</numerusform>
            <numerusform>%n płytek</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Model musi mieć jakiś materiał; najpierw dodaj inny</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Usuń ten materiał</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Z pliku…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Dodaje materiał z pliku</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>Modele FlatFitFab (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Zrób jego %n płytkę z</numerusform>
            <numerusform>Zrób jego %n płytki z</numerusform>
            <numerusform>Zrób jego %n płytek z</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Dodaj materiał: %1</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Usuń materiał: %1</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Zapisz…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressCard</name>
    <message>
        <source>%1&#x202f;MPa, %2&#x202f;%</source>
        <extracomment>%1 is a stress in megapascals, %2 a number of percent</extracomment>
        <translation>%1&#x202f;MPa, %2%</translation>
    </message>
    <message>
        <source>In the neck</source>
        <translation>W przewężeniu</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>W jego narożniku</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>Zginanie w płaszczyźnie</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Zginanie w poprzek arkusza</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>Ściskanie wzdłuż</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>Rozciąganie wzdłuż</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Ścinanie</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Skręcanie</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>Tak smukłe, że może się wyboczyć, zanim się złamie.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Niepewne: siły działają obok otworów, przez które to przechodzi.</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Liczba przybliżona: przewężenie jest za krótkie albo za blisko siły.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Najpierw pękłoby w narożniku.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Złamałoby się prosto w poprzek.</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1%</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressMarks</name>
    <message>
        <source>Stress</source>
        <translation>Naprężenia</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Współczynnik bezpieczeństwa %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Wytrzymałość nieznana</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Nic powyżej %1%</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>Ruch %1&#x202f;×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Nie stoi; naprężeń nie pokazano.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Połączenie się rozsuwa; naprężeń nie pokazano.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Nie udało się obliczyć, czy utrzyma.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Szukanie płytek…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Budowanie ścianek…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Rozwijanie…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>Odrysowywanie %1…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>Utworzono %n płytkę.</numerusform>
            <numerusform>Utworzono %n płytki.</numerusform>
            <numerusform>Utworzono %n płytek.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Najpierw zaznacz płytkę, w której mają być otwory, albo połóż na niej rysunek.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Najpierw zaznacz płytkę do grawerowania albo połóż na niej rysunek.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Szukanie płaszczyzn…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>czytany za każdym razem</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>zapisany w modelu</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Znajdź plik…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Czyta podkład z miejsca, gdzie plik jest teraz; podkład zostaje na miejscu</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Połącz z plikiem…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>Nie zapisuje go w pliku modelu, który będzie mniejszy, i czyta go za każdym razem z jego miejsca</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>Zapisz w modelu</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>Zapisuje go w pliku modelu, żeby był też na innych komputerach</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>Przesuwa, obraca i skaluje go w widoku, uchwytami albo według liczb</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Według linii</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Narysuj na nim linię wzdłuż czegoś, czego długość znasz</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Przesuń i obróć</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Podkłady</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Dodaj podkład…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Wczytuje siatkę, obraz lub rysunek, według którego można rysować płytki</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Dodaj siatkę, obraz lub rysunek albo upuść je lub wklej. Rysowane płytki są przyciągane tam, gdzie ich płaszczyzna przecina siatkę, i do linii rysunku w ich płaszczyźnie.</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 zmienia nazwę, Spacja ukrywa, L blokuje, Del usuwa.</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Plastry…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>Tnie to na płytki oddające kształt</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Położenie i rozmiar</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Krycie</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Wymiary</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>nieznane</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Na podłoże</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Stawia na podłożu</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Postaw pionowo</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Kładzie na drugiej stronie: to, co w nim jest górą, jest górą w widoku</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>Brakuje: %1</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Odblokuj</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Zablokuj</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ukryj</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Pozycja</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X środka</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y środka</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z środka</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Obrócony wokół X, najpierw</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Obrócony wokół Y, po X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Obrócony wokół Z, na końcu</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Siatka, %n trójkąt</numerusform>
            <numerusform>Siatka, %n trójkąty</numerusform>
            <numerusform>Siatka, %n trójkątów</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Obraz, %1 × %2 pikseli</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Rysunek, %n linia</numerusform>
            <numerusform>Rysunek, %n linie</numerusform>
            <numerusform>Rysunek, %n linii</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Grubość</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Pomiń ten krok</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Zakończ przewodnik</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Przewodnik</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Przewodnik, krok %1 z %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Rozejrzyj się.&lt;/b&gt; Przeciągnij obok modelu, aby go obrócić; kółkiem się przybliżysz.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Wytnij.&lt;/b&gt; &lt;b&gt;Eksportuj…&lt;/b&gt; pokazuje arkusze i zapisuje plik dla wycinarki.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Narysuj tułów.&lt;/b&gt; Naciśnij na środku widoku i jednym pociągnięciem narysuj jego obrys, płaski u góry, aż do podłoża.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Narysuj płytkę w poprzek.&lt;/b&gt; Naciśnij wewnątrz tułowia i przeciągnij na zewnątrz przez jego krawędź. Nie puszczaj przycisku: widok się obraca. Potem narysuj obrys, znów aż do podłoża.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Zmierz swój arkusz.&lt;/b&gt; Kliknij materiał po prawej stronie paska narzędzi, potem jego grubość, i wpisz, ile zmierzono: wszystkie szczeliny się dopasują.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;Czy to zadziała?&lt;/b&gt; Mówią o tym etykiety nad widokiem. Kliknij jedną z nich, aby przeczytać więcej.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Powtórz ją.&lt;/b&gt; Wybierz &lt;b&gt;Rząd&lt;/b&gt;, kliknij płytkę w poprzek, a potem tułów: kopie staną wzdłuż niego w rzędzie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;To była cała droga,&lt;/b&gt; od pierwszej kreski do pliku. To, co czerwone, ma pod Kontrola odnośniki, które to naprawią. Naciśnij &lt;b&gt;F1&lt;/b&gt;, aby wiedzieć więcej.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Prawie.&lt;/b&gt; Cofnij okrągły uchwyt na końcu rzędu, aż żadna etykieta nie będzie czerwona; wtedy &lt;b&gt;Eksportuj…&lt;/b&gt; zapisze plik dla wycinarki.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;To bardzo mały kształt.&lt;/b&gt; Cofnij go i narysuj większy, mniej więcej na połowę szerokości widoku.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Tu kończy się przewodnik.&lt;/b&gt; Możesz przejść go ponownie z menu &lt;b&gt;Pomoc&lt;/b&gt;. Więcej pod &lt;b&gt;F1&lt;/b&gt;.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>Nie da się robić kopii niezapisanej pracy na wypadek awarii. Dla bezpieczeństwa zapisz ją.</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Tę pracę otwarto lub odrzucono w innym oknie.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>Nie udało się otworzyć kopii: %1.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>bez nazwy</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n krok</numerusform>
            <numerusform>%n kroki</numerusform>
            <numerusform>%n kroków</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Kopię niezapisanej pracy utworzył nowszy FlatFitFab; została zachowana jako %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Nie udało się odczytać kopii niezapisanej pracy; została zachowana jako %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kąt</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Liczba całkowita</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Proporcja</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Liczba</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Tak lub nie</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Wybór</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>small</source>
        <translation>małe</translation>
    </message>
    <message>
        <source>large</source>
        <translation>duże</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Opcje</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>małe | duże</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Powstaje z</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>nagłówek nad nią</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notatka</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>do czego służy</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Nie da się tego odczytać jako tego, co tu potrzebne.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>any</source>
        <translation>dowolne</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maksimum</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Inni mogą ją zmieniać</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Można ją ustawiać tam, gdzie projekt udostępniono do dopasowania</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>To, co z niej powstaje, staje się zwykłymi liczbami</translation>
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
        <translation>Nazwa wartości</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Rodzaj, zakres i notatka</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Tylko dla Ciebie</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>Zawężono zakres: %1.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>%n wypróbowany wariant jest dobry.</numerusform>
            <numerusform>Wszystkie %n wypróbowane warianty są dobre.</numerusform>
            <numerusform>Wszystkie %n wypróbowanych wariantów jest dobrych.</numerusform>
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
            <numerusform>Zawodzi %1 z %n wariantu: %2.</numerusform>
            <numerusform>Zawodzi %1 z %n wariantów: %2.</numerusform>
            <numerusform>Zawodzi %1 z %n wariantów: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>Wypróbowano skrajne ustawienia: %2 z %1.</translation>
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
            <numerusform>i %n inne</numerusform>
            <numerusform>i %n inne</numerusform>
            <numerusform>i %n innych</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Próbowanie zakresów… %1%</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Spróbuj ponownie</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Wypróbuj wszystkie zakresy</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Zawęź zakresy</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Mówi, gdzie w zakresach pokazanych wartości modelu nie da się złożyć, gdzie się złamie, przewróci albo nie zmieści.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nowa wartość</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>parametr</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Ten projekt jest do dopasowania: ustaw jego wartości, potem go wyeksportuj. Przeciągnij w widoku, aby go obrócić.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>Będzie wycięty z materiału: %1.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>W tym projekcie nie ma nic do dopasowania.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Edytuj projekt</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Udostępnij do dopasowania</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Przywraca rysowanie i wszystkie panele; zapisany teraz plik tak się otworzy.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Kto otworzy zapisany model, zobaczy widok, pokazane wartości i eksport, i nic więcej.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Nadaj liczbie nazwę: użyje jej każde pole, także w działaniach, np. = 2*luz.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Jak pokazano model</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rentgen</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Kliknij, aby znów zobaczyć płytki takie, jakie są.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Rozcięte</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Kliknij, aby znów zobaczyć cały model.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>GÓRA</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>DÓŁ</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>PRZÓD</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>TYŁ</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>PRAWO</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>LEWO</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>Widok modelu</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Rysuj lewym przyciskiem myszy, obracaj prawym.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 do warsztatu</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Wśród plików nie ma kroków: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Gdzie umieścić folder „%1”</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Umieść tutaj</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>na tym ekranie nie da się utworzyć obrazu.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Rysuje płaskie części w 3D i wycina je.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modele do otwarcia, każdy w osobnym oknie; rysunki, siatki i obrazy do dodania do nowego.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Otwiera FILE jako kopię: zapis zapyta o nazwę.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Odtwarza skrypt naciśnięć i ruchów.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>SKRYPT</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Uruchamia bez dotychczasowych ustawień i żadnych nie zachowuje.</translation>
    </message>
</context>
</TS>
