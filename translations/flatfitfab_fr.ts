<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n pièce d’un bloc</numerusform>
            <numerusform>%n pièces d’un bloc</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (pièce %2)</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (d’un bloc depuis l’étape %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n autre</numerusform>
            <numerusform>%n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>vers le haut</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>vers le bas</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>vers la droite</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>vers la gauche</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>vers l’avant</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>vers l’arrière</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>dans le sens de la flèche</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Il n’y a pas encore de section, donc pas d’étapes.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>Rien n’est découpé dans ce modèle, donc il n’y a pas d’étapes.</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Aucune étape à montrer&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>Aucune étape à montrer&#xa0;: l’ordre de montage n’a pas été trouvé à temps.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>Aucune étape à montrer&#xa0;: le modèle n’est pas montable, car %n section se bloque.</numerusform>
            <numerusform>Aucune étape à montrer&#xa0;: le modèle n’est pas montable, car %n sections se bloquent entre elles.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>Aucune étape à montrer&#xa0;: le modèle n’est pas montable, car des pièces de %1 se bloquent entre elles.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>Aucune étape à montrer&#xa0;: le modèle n’est pas montable, car %1 se bloquent entre elles.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Étape %1 sur %2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>commencer par %1</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>commencer un groupe à part avec %1</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>mettre %1 en place</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>faire entrer %1 en contournant l’obstacle, pour finir %2</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>faire entrer %1 en contournant l’obstacle, puis glisser %2 dans %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>amener %1 %2 en place</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>glisser %1 %2 dans %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Supporte encore %1 ici avant que %2 se fissure %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Supporte %1 ici avant que %2 se fissure %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Supporte encore %1 ici avant de se renverser.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Supporte %1 ici avant de se renverser.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Supporte encore %1 ici avant qu’un assemblage se déboîte.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Supporte %1 ici avant qu’un assemblage se déboîte.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Supporte plus de %1 ici.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>Ce qu’il supporte ici n’a pas pu être calculé.</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Élargir la base</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Ajouter un pied</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Relié. Une seule section pour l’instant.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 assemblage</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n assemblage</numerusform>
            <numerusform>%n assemblages</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Relié. Les deux sections, par %1.</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Relié. Les %1 sections, par %2.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Serait relié %1.</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 n’est pas reliée au reste.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 ne sont pas reliées au reste.</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 rencontre %2, mais rien ne les retient ensemble.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 rencontrent %2, mais rien ne les retient ensemble.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Rien ne touche %1. Elle est à %2 de %3.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Rien d’autre ne touche %1. Elles sont à %2 de %3.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Tout supprimer</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Relié</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Serait relié</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non relié</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Dessinez une section qui croise les deux, ou déplacez l’une vers l’autre.</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Pas encore relié</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>si tout tenait ensemble</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>si rien ne se disloquait</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>si le trait de coupe ne fermait aucune fente</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>si aucune fente n’était trop serrée</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>si aucune fente n’était trop large</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>s’il ne se repliait pas</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>s’il ne glissait pas</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>si rien ne se défaisait</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>si aucun assemblage ne se déboîtait</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>si rien ne le poussait</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>Faire finir l’une contre l’autre</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>Faire finir %1 contre %2</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>Leur assemblage est réglé sur «&#x202f;Aucun&#x202f;».</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Aucune fente ne permet de les emboîter&#xa0;: le jeu négatif ne lui laisserait aucune largeur. Augmentez le jeu.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Aucune fente ne permet de les emboîter&#xa0;: à un endroit elles ne coulisseraient que dans un sens, à un autre que dans l’autre. Raccourcissez l’une d’elles.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Rien ne les retiendrait&#xa0;: il y a des trous là où les fentes commenceraient. Réduisez les trous, ou laissez l’une finir à l’intérieur de l’autre.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Aucune fente ne permet de les emboîter&#xa0;: aucune des deux n’atteint le bord. Ouvrez un trou vers l’extérieur, ou laissez l’une traverser l’autre.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 et %2 se chevauchent sur une longueur de %3. %4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>moins de %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 et %2 se chevauchent de %3, en dehors de leurs fentes.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 et %2 se chevauchent de %3, mais ne sont pas assemblées.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 et %2 sont presque dans le même plan&#xa0;: elles se croisent à %3, et au-dessous de %4 aucune fente ne peut les retenir.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 et %2 se croisent à %3&#x202f;; au-dessous de %4, les fentes deviennent larges.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Écartez l’une d’elles, ou faites-la finir avant l’autre.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Des sections se chevauchent</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Angle trop faible</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Tournez l’une d’elles vers un angle plus grand.</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Les assembler</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Assembler avec %1</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Les assembler avec %1</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déplacer vers %1</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Les déplacer vers %1</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Raccourcir %1</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Assembler par tenons</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 ne retient pas %2&#xa0;: sa fente longe le bord et n’a de la matière que d’un côté.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 ne retient pas %2&#xa0;: ses fentes la traversent complètement à cet endroit.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 ne retient pas %2&#xa0;: sa fente fait moins de %3 de profondeur.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 ne retient pas %2&#xa0;: sa fente ne laisse de matière d’aucun côté.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 ne retient pas %2&#xa0;: d’autres fentes enlèvent ce qui entrerait dans la sienne.</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Éloignez la fente du bord.</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Faites finir une des sections qui s’y croisent avant les autres, ou écartez-la.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>Fente qui ne retient rien</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>Des fentes coupent %1 en %2 pièces</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 donne %2 pièces</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1&#x202f;; rien n’en retient une, de %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1&#x202f;; rien ne les retient, la plus grande fait %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1&#x202f;; rien n’en retient %2, dont la plus grande fait %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>Des fentes coupent %1 en morceaux. Ce qui est coupé tient ensemble, mais rien ne le retient.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>Des fentes coupent %1 en morceaux. Rien ne retient ce qui est coupé avec %2.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>Des fentes coupent %1 en morceaux. Rien ne retient son morceau de %2 avec %3.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Inverser les fentes</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Pièces libres</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Éloigner %1 du bord</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Éloigner %1</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Réduire la profondeur de la fente</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>La fente %1 est fermée par le trait de coupe de %2. Donnez plus de jeu aux fentes du matériau, ou un trait de coupe plus fin.</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>La fente %1 est plus étroite que l’outil de %2. Donnez plus de jeu aux fentes du matériau, ou choisissez un outil plus fin.</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Entre leurs bossages, les fentes sont plus étroites de %1 que ce qui y entre. C’est trop serré pour n’importe quel matériau&#xa0;: réduisez les bossages.</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>Les fentes sont plus étroites de %1 que ce qui y entre. C’est trop serré pour n’importe quel matériau.</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>Les fentes sont plus larges de %1 que ce qui y entre&#xa0;: il y a du jeu.</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Régler le jeu</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Fentes trop serrées</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Fentes trop larges</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Fente plus étroite que l’outil</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Afficher la copie pour un rapport</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Non calculé</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Montable. Une seule pièce pour l’instant.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Montable. Mais rien ne retient une des pièces.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Montable. Mais rien ne retient %n des pièces.</numerusform>
            <numerusform>Montable. Mais rien ne retient %n des pièces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Montable. %n étape.</numerusform>
            <numerusform>Montable. %n étapes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Serait montable %1.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Pas encore montable. Il le serait si deux sections ne se chevauchaient pas.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Pas encore montable. Il le serait si %n paire de sections ne se chevauchait pas.</numerusform>
            <numerusform>Pas encore montable. Il le serait si %n paires de sections ne se chevauchaient pas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Afficher les étapes</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>Des sections se bloquent. %1 se rencontrent en %2 qui coulissent dans %3 directions différentes.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>Des sections se bloquent. %1 ne sort que de %2 de sa fente avant de heurter %3.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>Des sections se bloquent. Aucune de %1 ne peut être retirée en ligne droite.</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Rendre montable</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>1 assemblage inversé.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>%n assemblage inversé.</numerusform>
            <numerusform>%n assemblages inversés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Ordre non trouvé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Ordre non trouvé. La recherche a pris trop de temps&#x202f;; cela ne dit rien du modèle.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Montable</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Serait montable</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Pas encore montable</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>Non montable</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Raccourcissez l’une d’elles, ou tournez-la pour qu’elle coulisse dans la même direction que les autres.</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Ordre non trouvé</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Se déboîte. L’assemblage de %1 et %2 est écarté par %3&#xa0;N.</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>Ne porte rien. L’assemblage de %1 et %2 est écarté par %3&#xa0;N&#x202f;; les autres tiennent sans lui.</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Retenu par frottement. L’assemblage de %1 et %2 est tiré par %3&#xa0;N&#xa0;: seul un ajustement serré y résiste.</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Se déboîte</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>Ne porte rien</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>Inverser ses fentes</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Collez-le.</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Retenu par frottement</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Renversé par une poussée. Sans poussées, il tiendrait debout.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Renversé par une poussée</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Donnez-lui une base plus large ou plus de poids, ou poussez moins fort, ou plus bas.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 sont assemblées en anneau&#xa0;: montez-les dans l’ordre des étapes.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 sont assemblées en anneau&#xa0;: la dernière à entrer, quelle qu’elle soit, doit coulisser sur deux autres à la fois.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Des sections sont assemblées en %n anneau&#xa0;: montez-les dans l’ordre des étapes.</numerusform>
            <numerusform>Des sections sont assemblées en %n anneaux&#xa0;: montez-les dans l’ordre des étapes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Des sections sont assemblées en %n anneau&#xa0;: la dernière à entrer, quelle qu’elle soit, doit coulisser sur deux autres à la fois.</numerusform>
            <numerusform>Des sections sont assemblées en %n anneaux&#xa0;: dans chacun, la dernière à entrer, quelle qu’elle soit, doit coulisser sur deux autres à la fois.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>Assemblées en anneau</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Soutenir par un pied</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 plaque</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n plaque</numerusform>
            <numerusform>%n plaques</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Tient sur la plaque. %1, utilisation %2&#xa0;%.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Tient sur la plaque. %1 de %2, utilisation %3&#xa0;%.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%1 pièces de %2 ne tiennent sur aucune plaque de %3 avec une marge de %4, quel que soit leur sens.</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 mesure %2 et ne tient sur aucune plaque de %3 avec une marge de %4, quel que soit son sens.</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Choisir une plaque</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Tient sur la plaque</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>Trop grand pour la plaque</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Les prolonger jusqu’au sol</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Prolonger %1 jusqu’au sol</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Poser au sol</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Remonter jusqu’au sol</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Tient debout, mais est bancal (%1). Ne bascule qu’au-delà de %2. Marge&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Tient debout. Ne bascule qu’au-delà de %1. Marge&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Tient debout, penché de %1. Ne bascule qu’au-delà de %2. Marge&#xa0;: %3.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>Le point le plus bas de %1 est à %2 au-dessus du sol.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>Les points les plus bas de %1 sont jusqu’à %2 au-dessus du sol.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Penche de %1 vers l’avant</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Penche de %1 vers l’arrière</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Penche de %1 vers sa gauche</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Penche de %1 vers sa droite</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Bancal (%1)&#xa0;: ses points les plus bas ne sont pas tous au sol. Ne bascule qu’au-delà de %2.</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1, puis tient debout&#xa0;: ses points les plus bas ne sont pas tous au sol. Ne bascule qu’au-delà de %2.</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Tiendrait debout %1. Ne basculerait qu’au-delà de %2. Marge&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Tombe au moindre contact&#xa0;: incliné de %1, il bascule. Marge&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Tient à peine debout&#xa0;: incliné de %1, il bascule. Marge&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Bancal</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Penche</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Tombe au moindre contact</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Bascule facilement</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Se renverse vers l’avant. Le centre de gravité est à %1 devant les pieds.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Se renverse vers l’arrière. Le centre de gravité est à %1 derrière les pieds.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Se renverse vers sa gauche. Le centre de gravité est à %1 en dehors des pieds.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Se renverse vers sa droite. Le centre de gravité est à %1 en dehors des pieds.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Se renverse. Ses pieds sont tous sur une même ligne&#xa0;: rien ne le retient.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>Pas au sol. Leur point le plus bas est à %1 du sol.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>Pas au sol. Son point le plus bas est à %1 du sol.</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Donnez-lui un pied de plus, ou déplacez du poids au-dessus de ses pieds.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Assemblez-la avec ce qui tient debout, ou déplacez-la jusqu’au sol.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Ne tient pas encore debout</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Pas encore au sol</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Tient debout</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Tiendrait debout</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Faites finir tous ses pieds à la même hauteur.</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Se renverse</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>Pas au sol</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 fois autant</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>sa charge</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Assez solide</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Supporte %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Serait assez solide</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Supporterait %1</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Peut se fissurer</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Tout juste assez solide</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Peut se fissurer sous %1</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Supporte tout juste %1</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Va casser</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Trop fragile</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Casse sous %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Trop fragile pour %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 casse %2 à partir de %3.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 peut se fissurer %2 à partir de %3&#x202f;;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>son étranglement casse à %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>l’étranglement de %1 casse à %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 peut se fissurer %2 à partir de %3.</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Avec %1, un assemblage se déboîte.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Avec %1, il ne tient plus debout.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Il supporterait bien plus.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>Ce qu’il supporterait n’a pas pu être calculé.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>Rien ne le sollicite.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Point le plus faible&#xa0;: %1, %2, à moins de 1&#xa0;% de sa résistance.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>Point le plus faible&#xa0;: %1, %2, à %3&#xa0;% de sa résistance.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Fléchit de %1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>L’étranglement de %1 est sollicité à %2&#xa0;% de sa résistance.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>C’est moins de réserve que le coefficient de sécurité de %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Résistance inconnue. Aucune résistance n’est indiquée pour le matériau de %1.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Résistance inconnue. Les forces entre les sections n’ont pas pu être calculées.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Résistance inconnue. La contrainte dans %1 n’a pas pu être calculée.</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Glisse. Ses pieds ne résistent pas à ce qui le pousse&#xa0;: poussez moins fort, ou donnez-lui plus de poids.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Se défait. Rien ne maintient %1 en place&#xa0;: collez les assemblages, ou ajoutez-en un.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Se replie. Les créneaux tournent comme des charnières, et rien d’autre n’empêche %1 de tourner&#xa0;: collez-les, ou assemblez avec une section de plus.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Hors de la matière. Un poids sur %1 tombe à côté de sa matière&#x202f;; l’endroit le plus proche le porte.</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Prenez un matériau plus épais, élargissez à cet endroit, ou chargez moins.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Résistance inconnue</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Se défait</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Se replie</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Hors de la matière</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Prendre une épaisseur de %1</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Prendre un matériau plus épais</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Saisir sa résistance</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Se disloque. Ce qui tient %1 ensemble est trop mince pour être découpé.</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Trop peu de matière. %1 ne fait que %2 de large à un endroit.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Se disloque</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Élargissez à cet endroit, ou écartez ce qui se touche.</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Trop peu de matière</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Élargissez-la à cet endroit.</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1&#xa0;: ses fentes pour %2 se rejoignent.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1&#xa0;: il ne reste rien entre ses fentes pour %2.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1&#xa0;: il ne reste rien entre sa fente pour %2 et un trou.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1&#xa0;: il ne reste rien entre sa fente pour %2 et son bord.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1&#xa0;: il ne reste que %2 de matière entre ses fentes pour %3.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1&#xa0;: il ne reste que %2 de matière entre sa fente pour %3 et un trou.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1&#xa0;: il ne reste que %2 de matière entre sa fente pour %3 et son bord.</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Plutôt mince</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Élargissez la section à cet endroit, ou déplacez la fente.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Des fentes se rejoignent</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Masse %1. Le centre de gravité est à %2 au-dessus du sol.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 et %2 ne font que se toucher&#xa0;: elles se chevauchent de moins de %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n paire de sections ne fait que se toucher&#xa0;: elles se chevauchent de moins de %1.</numerusform>
            <numerusform>%n paires de sections ne font que se toucher&#xa0;: elles se chevauchent de moins de %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Se touchent seulement</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Tourner %1 à 90°</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Des fentes détachent de %1 un éclat de moins de 1&#xa0;mm². C’est un déchet, sans numéro.</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Des fentes détachent de %1 %n éclat de moins de 1&#xa0;mm². C’est un déchet, sans numéro.</numerusform>
            <numerusform>Des fentes détachent de %1 %n éclats de moins de 1&#xa0;mm². Ce sont des déchets, sans numéro.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Déchets</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>Les fentes de %1 la divisent en %2, que d’autres sections maintiennent.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pièce</numerusform>
            <numerusform>%n pièces</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>Les fentes de %1 n’en laissent rien.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>%1 n’a pas pu être découpée&#xa0;: ce que ses fentes en laissent n’a pas pu être calculé. Rien ne peut être exporté&#x202f;; sa masse compte sans les fentes.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 n’a pas pu être calculée&#xa0;: il manque des sections. Rien ne peut être exporté.</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Divisée par des fentes</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>Il ne reste rien</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Non découpée</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>Échec de l’opération</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Élargir à cet endroit</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n section déplacée</numerusform>
            <numerusform>%n sections déplacées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n section descendue de %1</numerusform>
            <numerusform>%n sections descendues de %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>%n section remontée de %1</numerusform>
            <numerusform>%n sections remontées de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>1 assemblage inversé</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>%n assemblage inversé</numerusform>
            <numerusform>%n assemblages inversés</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 passe à %2 d’épaisseur</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>Les fentes de 1 assemblage se rencontrent ailleurs</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>Les fentes de %n assemblage se rencontrent ailleurs</numerusform>
            <numerusform>Les fentes de %n assemblages se rencontrent ailleurs</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 déplacée de %2</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1 tournée de %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>%n section tournée</numerusform>
            <numerusform>%n sections tournées</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>un nouvel assemblage avec une fente de %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 nouvel assemblage</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n nouvel assemblage</numerusform>
            <numerusform>%n nouveaux assemblages</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 change de forme</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>%n section change de forme</numerusform>
            <numerusform>%n sections changent de forme</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 ajoutée</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n section ajoutée</numerusform>
            <numerusform>%n sections ajoutées</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 supprimée</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n section supprimée</numerusform>
            <numerusform>%n sections supprimées</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>plus rien n’est coupé de part en part</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>1 problème résolu</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n problème résolu</numerusform>
            <numerusform>%n problèmes résolus</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>ensuite&#xa0;: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>nouveau&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n nouvelle remarque</numerusform>
            <numerusform>%n nouvelles remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>à côté de sa fente pour %1</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>là où elle rejoint %1</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>dans un coin intérieur</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>à son étranglement</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#xa0;N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>Assemblées en anneaux</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>Dans le sol. %1 descend à %2 sous le sol.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>Dans le sol. %1 descendent jusqu’à %2 sous le sol.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>Dans le sol</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Décaler les plans de %1 %</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>Un plan de plus par direction</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Tient sur les plaques et les chutes disponibles.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>Au plus %n plaque</numerusform>
            <numerusform>Au plus %n plaques</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Tient sur la plaque. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Tient sur la plaque. %1 de %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Des sections se chevauchent un peu</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>Les plaques peuvent manquer. Il faut jusqu’à %n plaque de %1, et il y en a %2.</numerusform>
            <numerusform>Les plaques peuvent manquer. Il faut jusqu’à %n plaques de %1, et il y en a %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>Les plaques peuvent manquer</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Voyez dans Plaques à quel point les pièces peuvent être serrées.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Des plans tous les %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, décalé de %2&#xa0;%</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>Un plan de plus</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>Un plan de moins par direction</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>Un plan de moins</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>Deux plans de plus par direction</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>Deux plans de plus</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>Deux plans de moins par direction</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>Deux plans de moins</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Aucun des décalages et nombres de plans essayés ne leur permet de coulisser ensemble. Convertissez les tranches et raccourcissez l’une d’elles, ou supprimez-la.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>Ce modèle est là pour être réglé&#x202f;; «&#x202f;Modifier la conception&#x202f;» ramène tout</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Ouvrir un modèle, y compris de FlatFab</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>Insérer un modèle…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insérer</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>Ajouter à ce modèle les sections d’un autre</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>Gabarit à décalquer…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Lire un maillage, une image ou un dessin pour dessiner des sections par-dessus</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>Ajouter à la bibliothèque</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>Garder la sélection dans la bibliothèque, pour d’autres modèles</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Enregistrer le modèle</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enreg. sous</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Enregistrer le modèle sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Exporter les fichiers de découpe…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>Écrire les pièces dans un fichier pour la découpeuse laser</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Réexporter</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Réexporter</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Écrire le même fichier, avec les mêmes choix</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Revenir à la version enregistrée</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Revenir au modèle tel qu’il est dans son fichier&#x202f;; Annuler ramène les modifications</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Préférences…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Unités, couleurs, langue, fichiers et raccourcis</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Raccourcis clavier…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Voir quelles touches font quoi, et choisir les vôtres</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Fermer la fenêtre</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Fermer cette fenêtre&#x202f;; les autres restent ouvertes</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Fermer toutes les fenêtres et le programme</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Aller aux propriétés</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Aller au premier champ de la sélection&#x202f;; dans la vue, Entrée fait de même</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Masquer tous les panneaux</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Masquer tout</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>Masquer ou afficher les panneaux latéraux</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Remplir l’écran avec la fenêtre</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Réinitialiser la fenêtre</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Réinitialiser la fenêtre</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Remettre tous les panneaux à leur place d’origine</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Zone suivante de la fenêtre</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Zone suiv.</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Aller à la zone suivante de la fenêtre&#xa0;: barre d’outils, gauche, vue, droite</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Zone précédente de la fenêtre</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Zone préc.</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Revenir à la zone précédente de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>Problème suivant</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Problème suivant</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>Sélectionner et montrer les sections du problème suivant</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>Problème précédent</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Problème précédent</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>Sélectionner les sections du problème précédent</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Afficher les étapes</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Montrer étape par étape comment monter le modèle</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Matériaux…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Matériaux</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Matériaux en plaque&#xa0;: épaisseur, résistance, trait de coupe et format</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Pièce d’essai…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Pièce d’essai</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Écrire une pièce d’essai qui dit quelles fentes vont bien et quelle largeur la machine enlève</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>Plaques</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Plaques</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>Montrer les pièces sur leurs plaques, telles qu’elles seront découpées</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Aller aux valeurs</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>Régler les valeurs dont dépendent des nombres du modèle</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nouvelle valeur</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Un nombre qui porte un nom, que les champs numériques acceptent</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Rechercher une commande…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Taper pour trouver tout ce que le programme sait faire</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Comment naît un modèle, pas à pas et en images</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Page d’accueil</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Page d’accueil</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Modèles récents et exemples</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>À propos de FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>Ce qu’est ce programme, sa version et ses licences</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Il n’a pas encore été exporté</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Il n’a jamais été enregistré</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Rien n’a changé depuis l’enregistrement</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Carte de résistance</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Carte de résistance</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Colorer une section selon la masse que chaque endroit peut supporter</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Sélectionnez d’abord la section à examiner</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Sélectionnez d’abord une section</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>Aucun assemblage n’est sélectionné&#xa0;: sélectionnez une section, puis un de ses assemblages</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>Il n’y a pas d’autre section</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>Aucune opération n’est sélectionnée</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Il n’y a pas encore de section</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>Aucune section n’est sélectionnée</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>Copier les sections sélectionnées et les supprimer</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>Copier les sections sélectionnées, aussi pour d’autres fenêtres et programmes</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>Ajouter les sections copiées, ou une image à décalquer</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>Poser à côté une copie des sections sélectionnées</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>En X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>Miroir X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Poser une image en miroir des sections sélectionnées de l’autre côté du plan où X vaut 0</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>En Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Miroir Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Poser une image en miroir des sections sélectionnées de l’autre côté du plan où Y vaut 0</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>En Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Miroir Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Poser une image en miroir des sections sélectionnées de l’autre côté du plan où Z vaut 0</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>Par une section…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Cliquez sur une section&#xa0;: une image en miroir des sections sélectionnées se place de l’autre côté</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Sections depuis SVG…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>Depuis SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Une section pour chaque contour d’un dessin</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>Contour depuis SVG…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Contour depuis SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>Le plus grand contour d’un dessin à la place de celui de la section sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>Trous depuis SVG…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Trous depuis SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Un trou dans la section sélectionnée pour chaque contour d’un dessin</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>Marquages depuis SVG…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Marquages depuis SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>Les lignes d’un dessin, gravées ou incisées sur la section sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Dessiner une forme</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Étirer un cercle, un rectangle, etc. depuis son centre</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>Par des nombres&#xa0;: un trou dans la section sélectionnée, ou une section à part</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>Oblong</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Oblong</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Déplacer un gabarit</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Poignées</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Déplacer, tourner et redimensionner le gabarit avec des poignées ou des nombres</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Dimensionner un gabarit par une ligne</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Par une ligne</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Tracer une ligne sur le gabarit et dire sa longueur</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>Il n’y a ni image ni dessin&#xa0;: ajoutez-en un d’abord</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>Il n’y a pas de gabarit&#xa0;: ajoutez d’abord un maillage ou une image</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Inverser les fentes de l’assemblage</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Inverser les fentes</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>Ouvrir les fentes de l’assemblage sélectionné de l’autre côté</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Rétablir les réglages automatiques</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Laisser de nouveau le programme choisir le type, le sens et les points de rencontre de l’assemblage sélectionné</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>Rien n’est réglé à la main sur cet assemblage</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>Ajouter un poids</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Poser un poids sur une section pour voir ce qu’elle supporte</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>Ajouter une poussée</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>Pousser ou tirer une section à un endroit pour voir ce qu’elle supporte</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>Tirer ici</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tirer</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Tirer une section avec la souris pour voir ce qui se passe&#x202f;; rien n’est gardé</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Rien n’agit sur le modèle&#xa0;: ajoutez d’abord un poids ou une poussée</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>Il n’y a aucun maillage à attirer</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Ajouter du texte ou des lignes à graver</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Graver</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Écrire ou dessiner sur une section, pour la graver ou l’inciser</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>Graver</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>Ce qui est dessiné ensuite est gravé</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>Inciser</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Inciser</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>Ce qui est dessiné ensuite est incisé, pour y plier ou casser</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>Mesurer entre deux endroits&#x202f;; garder la longueur, ou redimensionner le modèle d’après elle</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Redimensionner à une longueur</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Redimensionner à une longueur</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Fixer une longueur et redimensionner le modèle d’après elle</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Garder la longueur</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Continuer d’afficher cette longueur</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Supprimer cette cote</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Supprimer cette cote</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>Rien n’est mesuré</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>Aucune cote n’est choisie&#xa0;: cliquez sur l’une d’elles avec Mesurer</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>Miroir…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>Mettre en miroir les sections sélectionnées, ou un côté du modèle sur l’autre</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Miroir gauche-droite (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>Miroir par rapport au plan où X vaut 0</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Miroir haut-bas (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Miroir par rapport au plan où Y vaut 0</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Miroir avant-arrière (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Miroir par rapport au plan où Z vaut 0</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>Miroir par une section</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>Miroir par rapport au plan de la section cliquée</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Copie en miroir de la sélection</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Ajouter une image en miroir des sections sélectionnées</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Garder les deux côtés identiques</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Deux côtés</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Mettre en miroir tout ce qui est dessiné d’un côté, maintenant et ensuite</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Rendre symétrique une fois</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Une fois</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>Copier un côté sur l’autre&#x202f;; les modifications suivantes ne sont pas copiées</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Appliquer le miroir affiché</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Faire ce qui est affiché</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Choisissez d’abord Miroir</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>Prendre la forme proposée</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Proposition</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Faire de ce qui vient d’être dessiné le cercle, l’ellipse, les lignes droites ou les angles droits proposés, ou éloigner sa fente du bord</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>Prendre tout le guide</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Guide entier</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>Faire la section de tout ce que son plan coupe d’un gabarit, avec ses trous</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>Rien n’est proposé pour ce qui vient d’être dessiné</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>Le plan de dessin ne coupe aucun gabarit</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>Rangée</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Rangée</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>Répéter une section en rangée le long d’une autre</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>Pourtour d’un contour</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Pourtour</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Répéter une section autour du contour d’une autre</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Interpoler entre des sections</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>Ramification</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Faire pousser des copies d’une section à partir d’elle-même, comme un arbre</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Grille à connecteurs</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Diviser une section trop grande pour la plaque</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>Contour radial</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>Faire d’une section un cercle, une étoile ou un engrenage, ou y découper de tels trous</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>Modèle en miroir</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Répéter d’un côté tout ce qui est dessiné de l’autre</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Symétrie de rotation</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Répéter tout autour d’un axe ce qui est dessiné une fois</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>Réseau</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Réseau</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>Répéter des sections le long d’une ligne dans l’espace</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>Tranches d’un maillage</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Tranches</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Couper un maillage servant de gabarit en sections qui le suivent</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>Rendre symétrique maintenant</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symétrique</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>Mettre une fois un côté en miroir sur l’autre</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>Désactiver ou activer</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Active</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>Désactiver l’opération sélectionnée, ou la réactiver</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>Plus tôt dans l’ordre</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Plus tôt</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>Exécuter l’opération sélectionnée avant celle du dessus</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>Plus tard dans l’ordre</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>Exécuter l’opération sélectionnée après celle du dessous</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>Convertir en sections</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Convertir</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Faire des sections dessinées de ce que produit l’opération sélectionnée</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>Il n’y a pas de maillage à trancher&#xa0;: ajoutez-en un d’abord</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>C’est la première</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>C’est la dernière</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Accrochage</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Accrochage</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>S’accrocher aux points, aux lignes d’alignement et à la grille</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Plume</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Plume</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Dessiner par clics plutôt que d’un seul trait&#xa0;: placer des points, glisser pour courber</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>Aucun nombre n’est saisi</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Supprimer les trous</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Sans trous</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Fermer tous les trous des sections sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Ajouter un point de contrôle sous le pointeur, ou à côté du point sélectionné</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Supprimer le point</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Supprimer le point</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>Supprimer les points de contrôle sélectionnés</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Point lisse</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisse</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>Rendre le contour lisse aux points sélectionnés</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>Point symétrique</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>Rendre le contour lisse, avec des poignées de même longueur des deux côtés</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Point en coin</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Faire des coins aux points sélectionnés</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>Aucun point d’un contour n’est sélectionné</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Sélectionnez une seule section au contour modifiable</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>La sélection n’a pas de trous</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Déplacer et tourner</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Déplacer, tourner et redimensionner avec des poignées ou des nombres</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>Selon les axes du monde</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Axes monde</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Déplacer selon les axes du monde, non dans le plan de la section</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Déplacer les sections rattachées</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Rattachées</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Les sections dessinées sur celle-ci se déplacent avec elle</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Poser sur une autre section…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Poser sur</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Cliquez sur la section où poser la sélection</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Libérer de sa section porteuse</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libérer</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Rompre le lien avec sa section porteuse&#xa0;: elle ne la suit plus et ne garde plus son angle</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Mettre d’équerre</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>D’équerre</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>Mettre la section d’équerre avec celle qui la porte</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>Aligner sur l’axe le plus proche</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>Tourner la section pour qu’elle fasse face à un axe du monde</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>Protéger les sections sélectionnées des modifications</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>Modifier sa source</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>Sélectionner la section dont la sélection est tirée</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>Détacher celle-ci</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>Faire de la section sélectionnée une section dessinée&#x202f;; son opération continue de faire les autres</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>Exclure celle-ci</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Exclure</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>Exclure la section sélectionnée&#x202f;; son opération continue de faire les autres</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>La sélection n’est pas sur une autre section</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>La sélection est faite par une opération</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>La sélection n’est pas symétrique</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>La sélection est dessinée, non faite par une opération</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Sélectionner toutes les sections</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Sélectionner la suivante</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivante</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>Sélectionner la section suivante</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Sélectionner la précédente</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédente</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>Sélectionner la section précédente</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>Sélectionner les reliées</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Reliées</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Sélectionner toutes les sections reliées à la sélection</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>Sélectionner les parallèles</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallèles</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Sélectionner toutes les sections parallèles à la sélection</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Sélectionner le même matériau</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Même matériau</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Sélectionner toutes les sections du même matériau que la sélection</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Commencer un nouveau modèle</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Annuler la dernière étape</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>Rétablir l’étape annulée</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>Supprimer les sections sélectionnées</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Placer un point</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Rien à annuler</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Annuler «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Rien à rétablir</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Rétablir «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Désépingler toutes les pièces</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Tout désépingler</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Laisser de nouveau bouger toutes les pièces quand elles sont disposées sur les plaques</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>Aucune pièce n’est épinglée à sa plaque</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>Montrer la forme que suggèrent les sections, comme une surface qui les recouvre</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Symétrie locale</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Mettre un contour en miroir par rapport à sa fente quand il est dessiné d’un seul côté</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Couper à plat au sol</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Couper ce qui est dessiné sous le sol</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>Sur le sol</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Sur le sol</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Dessiner une section posée sur le sol</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>Sur le plan avant</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>À l’avant</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Dessiner une section debout au milieu, vue de devant</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>Sur le plan de côté</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>De côté</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Dessiner une section debout au milieu, vue de côté</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>Parallèle à la section</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Dessiner une section parallèle à la section sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Redessiner le contour</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Retracer</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Dessiner un nouveau contour pour la section sélectionnée</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>Dessiner un trou</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Trou</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>Dessiner un trou dans la section sélectionnée</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Poser au sol</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Poser</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Poser le modèle sur le sol</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>Le modèle est déjà au sol</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Transmettre pour réglage</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Transmettre</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Qui ouvre le modèle enregistré voit la vue, les valeurs affichées et l’export, et rien d’autre</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Modifier la conception</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Les autres ne peuvent encore régler aucune valeur</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Voir de devant</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Voir de dessus</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Voir de droite</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Voir de derrière</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Voir de dessous</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Voir de gauche</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Coin suivant</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Voir depuis le coin suivant</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Voir la section de face</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Regarder bien en face la section sélectionnée</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Tout cadrer</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Montrer tout le modèle</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Cadrer la sélection</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Cadrer la sélection</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>Montrer les sections sélectionnées le plus grand possible</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Vue précédente</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Revenir à la vue précédente</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>Montrer plus petit ce qui est plus loin, comme l’œil le voit</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Rayons X</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rayons X</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Voir à travers toutes les sections, jusqu’à leurs fentes</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Sélection seule</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoler</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Estomper toutes les autres sections</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>Masquer les sections sélectionnées</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>Afficher de nouveau les sections masquées</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Ouvrir la vue en coupe</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Ouvrir le modèle par un plan de coupe, pour voir à l’intérieur</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>Sol et ombre</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>Afficher le sol avec sa grille et l’ombre du modèle</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Lignes de contrainte</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Contrainte</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Montrer où le modèle est le plus sollicité</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>Aucune section n’est masquée</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>Il n’y a pas de vue avant celle-ci</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>La fenêtre simple s’en passe ; les Préférences ramènent la fenêtre complète</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Premier modèle en 3 minutes</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Dessiner, vérifier et découper un modèle pas à pas, dans une fenêtre vide</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Aide sur ce qui est sous le curseur</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Ouvrir l’aide là où elle parle de cette partie de la fenêtre</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>Ne pas refléter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Tout laisser comme avant</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Affiche du JSON, pour d’autres programmes.</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Sections, assemblages, taille et masse d’un modèle</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Si le modèle est relié, tient debout, est montable et tient sur la plaque</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Si le modèle est assez solide&#xa0;: forces, contraintes et ce qu’il supporte</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>Les pièces à découper, dans les coordonnées de chaque section</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Une image du modèle&#x202f;; nécessite un affichage</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Comment il se monte, étape par étape&#x202f;; nécessite un affichage</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>Les valeurs nommées d’un modèle, et ce qui en dépend</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Un fichier de découpe et un verdict pour chaque ligne d’un tableau de valeurs</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Tous les types d’opérations, ou les opérations d’un modèle</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>Les boucles selon lesquelles un plan coupe un maillage</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Des sections qui montrent un maillage, tiennent debout et sont montables</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Un modèle d’un maillage en tranches</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Un modèle en plaques planes avec des créneaux le long des bords</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Des pièces serrées sur des plaques, ou les éléments d’une bande (.json)</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Rejoue un script de ce qu’une personne fait dans la fenêtre</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Entièrement supprimées par les fentes, donc sans pièce&#xa0;: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>Trop grandes pour la plaque, sur des plaques à part&#xa0;: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Trop fines pour porter un numéro&#xa0;: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Un trou ou une encoche plus étroits que le trait de coupe ne sont pas découpés&#xa0;: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>Pas de place pour les numéros de tous les assemblages&#xa0;: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>La sortie standard n’a pas pu être écrite.</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>Rien à vérifier&#xa0;: le modèle n’a pas de sections.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>Les sections fléchissent là où des assemblages partagent une charge, par éléments finis&#x202f;; prend quelques secondes.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>La charge reste des mois&#xa0;: chaque matériau ne garde que la part de résistance prévue pour cela.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>«&#x202f;%1&#x202f;» n’existe pas.</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF avec un calque par usage</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Version d’un fichier DXF&#xa0;: r2000 ou r12 (r2000).</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>le modèle lui-même</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Millimètres par unité d’un fichier FlatFab (25.4).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-code pour lasers</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>un projet LightBurn</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>les solides en place</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>la liste des pièces</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF en grandeur réelle</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Pages d’un fichier PDF&#xa0;: sheet (une par plaque), ou réparties sur a4 ou letter (sheet).</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>une image des plaques</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Disposition des pièces dans un fichier STL ou 3MF&#xa0;: in-place (en place), ou flat, à plat sur leurs plaques (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>les pièces à imprimer</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>fichiers de découpe, en grandeur réelle</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>tout pour un atelier</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>il n’y a pas d’affichage avec OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>La recherche a été arrêtée avant la fin, car cet ordinateur est occupé : une autre exécution peut donner une autre disposition.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Fentes à essayer</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Bande à enfoncer</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Latte à mesurer</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Trop près du bord&#xa0;: la fente ne retiendrait rien</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Trop près du bord&#xa0;: la fente ne retiendrait rien. B&#xa0;: l’éloigner</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Éloignée de %1. B&#xa0;: la remettre</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontale</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>verticale</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>d’équerre avec le bord</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>parallèle à la précédente</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Rotation…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Dessinez le contour</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Pas encore assemblée</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>«&#x202f;%1&#x202f;» vaut %2, ce qui n’est pas possible ici.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>«&#x202f;%1&#x202f;» et une autre expression veulent ici deux nombres différents à la fois.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Ce à quoi ce nombre appartient n’existe plus.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cote</translation>
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
        <translation>Angle</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>X du centre</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>Y du centre</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>Hauteur des lettres</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Trait de coupe</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Largeur d’une plaque</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Hauteur d’une plaque</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Diamètre de l’outil</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Chanfrein d’entrée des fentes</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Bossages dans les fentes</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Rempli de</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Force selon X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Force selon Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Force perpendiculaire</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Point de rencontre</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>« %1 » n’est pas possible ici : des nombres liés à des valeurs le maintiennent à %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>« %1 » n’est pas possible ici : %2 suit « %3 », qui le garde tel quel.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>« %1 » ne peut pas être calculé.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>« %1 » est vide, ce qui n’est pas possible ici.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>il n’y a pas assez de mémoire</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>un maillage&#xa0;: ceci est plat</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>octets</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>entrées</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>sa table des matières est endommagée</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>cette entrée est endommagée</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>cette entrée est chiffrée</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>ce fichier contient plus que ce qu’il annonce</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>cette entrée figure deux fois</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>cette entrée est compressée d’une manière inconnue</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>cette entrée porte un autre nom que dans la table des matières</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>des entrées y partagent leurs octets</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>cette entrée se décompresse en beaucoup trop de données</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>des données gzip intactes</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>la suite des données gzip</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>une plaque plus grande</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>un fichier doit avoir un nom</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>ce fichier est en lecture seule</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>ce dossier est en lecture seule</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>un modèle</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>cette valeur n’est pas permise ici</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>rien trouvé, attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>ce nombre n’est pas possible</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>nombre trouvé&#xa0;: %1, attendu&#xa0;: au plus %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>trouvé&#xa0;: %1 %3, attendu&#xa0;: au plus %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>fait par une version plus récente de FlatFitFab</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>fait par une version plus récente de FlatFitFab&#xa0;: format trouvé&#xa0;: %1, attendu&#xa0;: au plus %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>ces points de contrôle ne forment pas un contour fermé</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>ces points de contrôle ne forment pas un contour fermé&#xa0;: trouvé&#xa0;: %1, attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>aucun chemin ne peut suivre ce contour partout à un demi-trait de coupe</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>aucun chemin ne peut suivre %1 partout à la moitié du trait de coupe de %2&#xa0;mm&#x202f;; lissez les plus petits détails de son contour, ou donnez à son matériau un autre trait de coupe</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>le trait de coupe ferme une fente</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 a une fente de %2&#xa0;mm de large, qu’un trait de coupe de %3&#xa0;mm fermerait</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>un fichier %1</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>un fichier %1 de %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>n’a pas pu être ouvert</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>n’a pas pu être écrit</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>ce n’est pas un modèle, attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>le fichier finit ici, attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>le fichier finit trop tôt</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: un nombre fini</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>un nombre n’est pas fini</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>ces axes ne forment pas un repère, attendu&#xa0;: deux axes de longueur 1 à angle droit</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>ce contour n’entoure aucune surface</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>rien ne porte le numéro %1</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>cela renvoie à quelque chose qui n’existe pas</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>le numéro %1 est utilisé deux fois, attendu&#xa0;: un numéro à part</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>ce numéro est utilisé deux fois, attendu&#xa0;: un numéro à part</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>ces deux sections sont presque parallèles et ne peuvent pas être assemblées</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>ce contour se croise lui-même</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>un trou toucherait le bord ou un autre trou</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>il resterait trop peu de points pour entourer quoi que ce soit</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>les fentes ne laissent rien d’aucune section, donc il n’y a rien à découper</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>il n’y a pas encore de section, donc rien à découper</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>aucun des endroits entre ses contours ne peut être recouvert (%1), donc il n’y a pas de peau</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>aucun contour n’en croise un autre à son bord, donc il n’y a pas de peau</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>il n’y a pas de commande «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>cette commande n’existe pas</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>cet événement n’a pas de sens ici</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas pris en charge par cette version</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>ce n’est pas pris en charge par cette version</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>cela n’a pas pu être calculé</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être découpée&#xa0;: ce que ses fentes en laissent n’a pas pu être calculé</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>une section n’a pas pu être découpée</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>le solide de «&#x202f;%1&#x202f;» n’a pas pu être calculé</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>un solide n’a pas pu être calculé</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>les marquages sur «&#x202f;%1&#x202f;» n’ont pas pu être coupés à son bord</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>les marquages sur une section n’ont pas pu être coupés à son bord</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>les sections de l’opération «&#x202f;%1&#x202f;» n’ont pas pu être calculées</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>les sections d’une opération n’ont pas pu être calculées</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>un problème est survenu dans FlatFitFab (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>un problème est survenu dans FlatFitFab</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>cela a été arrêté</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>le contenu de ce fichier est endommagé</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 était un peu de travers et a été redressée</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>une section était un peu de travers et a été redressée</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>le contour de %1 se croise lui-même&#x202f;; sa plus grande boucle a été gardée</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>un contour se croise lui-même&#x202f;; sa plus grande boucle a été gardée</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>un trou de %1 dépasse de son contour et a été omis</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>un trou dépasse de son contour et a été omis</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>un trou de %1 n’a pas de surface et a été omis</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>un trou n’a pas de surface et a été omis</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>des trous de %1 se chevauchent et ont été réunis en un seul</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>des trous se chevauchent et ont été réunis en un seul</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>un trou de %1 dépasse de son contour et en a été découpé</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>un trou dépasse de son contour et en a été découpé</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>les lignes après la dernière section ont été ignorées</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>le texte après la dernière section a été ignoré, lignes&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 n’a pas pu être lu et a été omis</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>une image ou un maillage a été omis</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 a été omis&#xa0;: %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>ce que montre %1 n’a pas pu être lu&#x202f;; sa place a été gardée</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>un gabarit n’a pas pu être lu&#x202f;; sa place a été gardée</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved ou scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>trois points de contrôle par segment et un de plus</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>au moins une ligne</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>deux endroits différents</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>un mot de lettres et de chiffres, une seule fois</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>ses données manquent</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>un SHA-256 de 64 chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>une entrée de ce nom n’a pas sa place ici</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>les données de cette entrée ne correspondent pas à son nom, un SHA-256</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>cette entrée manque</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>rien dans le document ne renvoie à cette entrée</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point, patch ou edge</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point, patch, edge ou hanging</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>une largeur de 1 à 10000&#xa0;mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>une force [x, y, z] supérieure à 0, au plus 1000000&#xa0;N</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>une hauteur de 0 à 10000&#xa0;mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>une partie de sa masse</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden ou detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>autre chose que made, chaque instance une seule fois</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>un identifiant inférieur à nextId</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>une part supérieure à 0, au plus 1</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>plus que l’opposé de l’épaisseur</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>une largeur et une hauteur supérieures à 0</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone ou tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>trois points de contrôle par segment, au moins 6</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom ou top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>une direction de longueur 1</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs ou none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>une part de 0.05 à 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>un souhait pour deux sections, paires en ordre croissant</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>une section porteuse qui ne descend pas de son enfant</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>au moins un matériau</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>chaque pièce une fois, dans l’ordre des sections</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>chaque section une fois, dans leur ordre</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none, half, quarter ou free</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh, picture ou curves</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>rien&#xa0;: seuls des maillages sont attirés</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>un rayon de 0.1 à 1000&#xa0;mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>le chemin d’un fichier</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>le SHA-256 d’un blob, ou un fichier</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>rien&#xa0;: un maillage ne repose sur aucune section</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>une échelle de 1e-9 à 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>une opacité de 0 à 1</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals ou groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>une expression moins longue</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice ou switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>un nom sans «&#x202f;=&#x202f;», chacun une seule fois</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>chaque valeur une seule fois</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>un mot de lettres et de chiffres, chacun une seule fois</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>chaque nombre une seule fois</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>une longueur d’au plus 1000000&#xa0;mm</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>un dernier point de contrôle qui répète le premier</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>un compte</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>un point de deux nombres</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>trois points de contrôle par segment et encore le premier, au moins 7</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>au moins 1 courbe</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>un tampon avec des octets</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>un tampon dans le fichier</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>une longueur que son tampon possède</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>un type de nombres de glTF</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>autant de valeurs que son tampon en a</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>autant de nombres qu’il en faut là</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>un nœud qui n’est pas en lui-même</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>un bloc d’un fichier GLB</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>version 2 de GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un fichier glTF</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>version 2 de glTF</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>un nombre supérieur à 0, au plus 1000000</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>un nombre de 0 à 1000000</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>un nombre entier dans sa plage</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>un point [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>un point [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>une liste de points</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>un nom entre guillemets ou la fin de l’objet</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>un deux-points</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>une virgule ou la fin de la liste</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>une séquence d’échappement JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>du texte en UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>la fin du texte entre guillemets</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>une autre valeur après la virgule</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>au plus 1024 niveaux</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>un fichier plus petit</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>chaque clé d’un objet une seule fois</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>les deux moitiés d’un caractère</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>une couleur comme #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>une épaisseur de lignes en mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>une vitesse en mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>une ligne de G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>des lignes de G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>le plus grand S</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>largeur et hauteur en mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>une part de 0 à 1</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>une largeur d’attaches en mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>une longueur d’amorces en mm</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>machines</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>une machine</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangles</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>il est dans un autre dossier</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>un maillage</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>au moins trois points</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon ou polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>au moins un angle</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>un problème d’imbrication sur une bande</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>au moins un élément</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>au moins trois sommets d’une face</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>le nombre de sommets</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>le nombre de faces</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>les sommets d’une face</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>l’image est endommagée</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>la suite de l’image</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>l’image est endommagée ici</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>une image PNG, JPEG ou WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>une image d’au moins un pixel</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>rien n’écrit dans ce tube</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>rien n’en est sorti pendant 10 secondes</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>rien ne lit ce tube</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>le format</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element ou end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii ou binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>un type comme float ou int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>d’abord un élément</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>autant de valeurs que le fichier en annonce</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y et z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>la longueur d’une liste</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>le nombre de triangles</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>autant de triangles que le fichier en annonce</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet ou endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex ou endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>trois sommets d’un triangle</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>des lignes&#x202f;; le texte doit d’abord être converti en tracés</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>des lignes&#x202f;; une image doit d’abord être vectorisée</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>lignes, formes ou tracés</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>une transformation</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>groupes imbriqués</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>des endroits à moins d’un kilomètre</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>paires de nombres</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>données de tracé</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>éléments et attributs</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>un dessin SVG</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>une longueur</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>une image ou un dessin</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>il n’y a pas de modèle 3D dans ce fichier</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>un modèle 3D</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>une unité comme millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>douze nombres</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>un objet qui ne se contient pas lui-même</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n section était un peu de travers et a été redressée.</numerusform>
            <numerusform>%n sections étaient un peu de travers et ont été redressées.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n contour se croisait lui-même&#x202f;; sa plus grande boucle a été gardée.</numerusform>
            <numerusform>%n contours se croisaient eux-mêmes&#x202f;; la plus grande boucle de chacun a été gardée.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n trou dépassait de son contour et a été omis.</numerusform>
            <numerusform>%n trous dépassaient de leur contour et ont été omis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n trou n’avait pas de surface et a été omis.</numerusform>
            <numerusform>%n trous n’avaient pas de surface et ont été omis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Des trous de %n section se chevauchaient et ont été réunis.</numerusform>
            <numerusform>Des trous de %n sections se chevauchaient et ont été réunis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n trou dépassait de son contour et en a été découpé.</numerusform>
            <numerusform>%n trous dépassaient de leur contour et en ont été découpés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Du texte après la dernière section a été ignoré à %n endroit.</numerusform>
            <numerusform>Du texte après la dernière section a été ignoré à %n endroits.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>%n image ou maillage n’a pas pu être lu et a été omis.</numerusform>
            <numerusform>%n images ou maillages n’ont pas pu être lus et ont été omis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>%n gabarit n’a pas pu être lu&#x202f;; sa place a été gardée.</numerusform>
            <numerusform>%n gabarits n’ont pas pu être lus&#x202f;; leur place a été gardée.</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>le dossier est inutilisable</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>il est ouvert dans une autre fenêtre</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>endroits où une ligne peut se croiser</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>ses données sont endommagées</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>un maillage d’au moins un triangle</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>une arête à trois faces ou plus</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>un maillage où deux faces se rencontrent à une arête</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>ce qui devait suivre « %1 » est maintenant un simple nombre</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n nombre ne suit plus ce qui avait été saisi.</numerusform>
            <numerusform>%n nombres ne suivent plus ce qui avait été saisi.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>une image</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>un dessin</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>chaque machine une fois, dans leur ordre</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>chutes</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>un contour à partir de 0, 0 qui ne se croise pas</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>épaisseurs</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>ce qu’une plaque peut avoir</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>matériaux</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>le contour est ouvert : ses extrémités sont à %1 mm l’une de l’autre</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>des coordonnées jusqu’à 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>objets placés</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Rayon des coins</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Côtés</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Diamètre intérieur</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Pointes</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Oblong</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>Impossible à fabriquer</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF, grandeur réelle</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, un par plaque</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF pour anciens programmes, R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>Modèles FlatFitFab</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code pour lasers GRBL</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code, un par plaque</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>Maillages glTF</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>Projet LightBurn</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, un par plaque</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>Maillages OBJ</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, solides en place</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, peau en maillage</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>Maillages OFF</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Liste des pièces pour tableur</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, une page par plaque</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, réparti sur A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, réparti sur Letter</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>Maillages PLY</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Image des plaques</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Images, une par plaque</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>Maillages STL</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, solides en place</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, peau en maillage</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, solides à plat</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG, grandeur réelle</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, un par plaque</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>Maillages 3MF</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, solides en place</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, solides à plat</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Tout pour l’atelier, compressé</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Tout pour l’atelier, dans un dossier</translation>
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
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; l’annule.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>Rien n’a été déplacé&#xa0;: là où %1 et %2 se rencontrent, il n’y a pas deux fentes qui se partagent la profondeur.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>Rien n’a changé&#xa0;: %1 et %2 ne peuvent pas être assemblées ainsi.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>Rien n’a été inversé&#xa0;: les fentes de %1 et %2 ne peuvent pas s’ouvrir de l’autre côté.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>Rien n’a été raccourci&#xa0;: %1 n’est pas dans %2, ou il n’en resterait rien.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Bougez pour déplacer la coupe, relâchez pour la laisser là. &lt;kbd&gt;Échap&lt;/kbd&gt; la remet en place.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>On ne peut pas dessiner sur un plan vu par la tranche&#xa0;: tournez la vue pour continuer.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Tracé abandonné&#xa0;: sa section n’existe plus.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>Rien n’a été dessiné&#xa0;: cette ligne ne donne aucune section. Tracez-la comme une boucle ouverte.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>Rien n’a été dessiné&#xa0;: tout se trouve sous le sol, où c’est coupé.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>Aucun trou n’a été fait&#xa0;: il doit se trouver dans %1 et la laisser en un seul morceau.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>Le trou dépasse du bord de %1 et en a été découpé.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>Le trou en touchait d’autres dans %1&#x202f;; ils ne forment plus qu’un trou.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>Les trous de %1 hors de son nouveau contour ont été omis.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez une section sur le sol, d’un seul trait. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez une section sur le plan avant, d’un seul trait. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez une section sur le plan de côté, d’un seul trait. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez une section parallèle à %1, d’un seul trait. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Dessinez le nouveau contour de %1, d’un seul trait. &lt;kbd&gt;Échap&lt;/kbd&gt; garde l’ancien.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez un trou dans %1, d’un seul trait. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez un trou&#xa0;: commencez sur la section qui le reçoit. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>Rien n’a été importé&#xa0;: aucune ligne de %1 ne forme un contour fermé. Ces lignes peuvent être gravées.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n contour de %1 ne convenait pas et a été omis.</numerusform>
            <numerusform>%n contours de %1 ne convenaient pas et ont été omis.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1&#xa0;: hormis %2, %3.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1&#xa0;: hormis %2 et %3, %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n texte</numerusform>
            <numerusform>%n textes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>%n ligne a été lue</numerusform>
            <numerusform>%n lignes ont été lues</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 est de biais par rapport à %1&#xa0;: amenez-le d’abord dans le plan de %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 a %n contour, c’est trop&#xa0;: vectorisez plus grossièrement, ou lissez d’abord.</numerusform>
            <numerusform>%1 a %n contours, c’est trop&#xa0;: vectorisez plus grossièrement, ou lissez d’abord.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Rien n’a été vectorisé&#xa0;: aucune partie de %1 n’est de ce côté du seuil.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1&#xa0;: faites glisser depuis son centre vers l’extérieur&#x202f;; un clic donne la taille habituelle.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1&#xa0;: faites glisser depuis son centre vers l’extérieur pour découper cette forme dans %2.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour lui donner cette taille&#x202f;; &lt;kbd&gt;Maj&lt;/kbd&gt; garde les deux côtés égaux. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Dessinez la première section&#xa0;: appuyez, tracez sa forme d’un seul trait, relâchez.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Faites glisser pour tourner la vue&#x202f;; avec &lt;kbd&gt;Maj&lt;/kbd&gt;, pour sélectionner un groupe.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Faites glisser hors de %1 pour dessiner une section en travers&#x202f;; cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Cliquez pour sélectionner %1. Faites glisser pour tourner la vue&#xa0;: on ne peut pas dessiner sur une section vue par la tranche.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Faites glisser pour déplacer la coupe dans le modèle&#x202f;; &lt;kbd&gt;Échap&lt;/kbd&gt; la ferme.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Cliquez pour sélectionner le problème %1.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Faites glisser pour déplacer le point&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait un coin, les flèches déplacent de 1&#xa0;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Faites glisser pour courber&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait un coin, &lt;kbd&gt;Maj&lt;/kbd&gt; garde la direction.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Double-cliquez pour ajouter un point ici&#x202f;; faites glisser pour courber le contour.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Cliquez pour sélectionner l’assemblage de %1 et %2.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Faites glisser pour creuser la fente de %1 et réduire celle de %2&#x202f;; cliquez pour sélectionner l’assemblage.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Faites glisser pour creuser la fente de %1 et réduire celle de %2&#x202f;; les flèches déplacent de 1&#xa0;mm.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Faites glisser pour déplacer le poids de %1 sur %2&#x202f;; cliquez pour le sélectionner.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Les flèches déplacent de 1&#xa0;mm le poids de %1 sur %2&#x202f;; &lt;kbd&gt;+&lt;/kbd&gt; et &lt;kbd&gt;−&lt;/kbd&gt; le modifient, &lt;kbd&gt;Suppr&lt;/kbd&gt; le retire.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Faites glisser pour déplacer la poussée de %1 sur %2, par sa pointe pour la tourner&#x202f;; cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Les flèches déplacent de 1&#xa0;mm la poussée de %1 sur %2&#x202f;; &lt;kbd&gt;+&lt;/kbd&gt; et &lt;kbd&gt;−&lt;/kbd&gt; la modifient, &lt;kbd&gt;Suppr&lt;/kbd&gt; la retire.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 est faite par %2&#xa0;: cliquez pour les modifier toutes, recliquez pour celle-ci seule.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Cliquez pour sélectionner %1 seule&#x202f;; faites glisser hors d’elle pour dessiner une section en travers.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Faites glisser une poignée ronde pour déplacer le début ou la fin de %1&#x202f;; cliquez sur une section pour la sélectionner.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Faites glisser pour déplacer le début de %1&#x202f;; cliquez pour le saisir.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Faites glisser pour déplacer la fin de %1&#x202f;; cliquez pour la saisir.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Cliquez pour voir de devant&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Cliquez pour voir de derrière&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Cliquez pour voir de gauche&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Cliquez pour voir de droite&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Cliquez pour voir de dessus&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Cliquez pour voir de dessous&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Cliquez pour voir cette arête de face&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Cliquez pour voir ce coin de face&#x202f;; faites glisser pour tourner la vue.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Faites glisser pour tourner la vue&#x202f;; la molette zoome.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour le laisser ici&#xa0;: la fente de %1 prend %2&#xa0;%. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Cliquez à un endroit d’une section pour y poser %1. &lt;kbd&gt;Échap&lt;/kbd&gt; termine.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Appuyez sur une section et faites glisser dans le sens de la poussée. &lt;kbd&gt;Échap&lt;/kbd&gt; termine.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Appuyez sur une section et faites glisser pour tirer dessus et voir ce qui se passe&#x202f;; rien n’est gardé.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Relâchez pour lâcher prise&#xa0;: rien n’est gardé.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Faites glisser pour déplacer. Un &lt;b&gt;clic&lt;/b&gt; sélectionne.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>Faites glisser la pointe pour tourner la poussée&#x202f;; une flèche plus longue pousse plus fort.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Relâchez pour poser le poids ici. &lt;kbd&gt;Échap&lt;/kbd&gt; le remet en place.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Relâchez pour pousser ici. &lt;kbd&gt;Échap&lt;/kbd&gt; la remet en place.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>Aucun poids n’a été ajouté&#xa0;: cliquez sur une section.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>Aucune poussée n’a été ajoutée&#xa0;: appuyez sur une section.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>La copie de %1 porte aussi cette charge&#x202f;; &lt;i&gt;Propriétés&lt;/i&gt; permet de la réserver à celle-ci.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>%n copie de %1 porte aussi cette charge&#x202f;; &lt;i&gt;Propriétés&lt;/i&gt; permet de la réserver à celle-ci.</numerusform>
            <numerusform>%n copies de %1 portent aussi cette charge&#x202f;; &lt;i&gt;Propriétés&lt;/i&gt; permet de la réserver à celle-ci.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Le poids reste où il est&#xa0;: là, il serait hors de %1.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>La poussée reste où elle est&#xa0;: là, elle serait hors de %1.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Faites glisser pour régler jusqu’où %1 attire les gabarits.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Relâchez pour que %1 attire les gabarits à partir de %2. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez sur la section à graver, ou cliquez dessus. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Faites glisser pour tracer une ligne sur %1&#x202f;; &lt;kbd&gt;Maj&lt;/kbd&gt; la garde droite. Cliquez pour placer du texte.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour garder la ligne. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 est gravée sur sa face avant, la seule que le laser atteint&#x202f;; la vue s’est tournée vers elle.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>Rien n’a été gravé&#xa0;: ce n’est pas sur %1.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>Le caractère «&#x202f;%1&#x202f;» ne peut pas être gravé.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Faites glisser d’un endroit à un autre pour mesurer&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; n’accroche pas. &lt;kbd&gt;Échap&lt;/kbd&gt; termine.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Allez au second endroit. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Cliquez ou faites glisser pour mesurer de nouveau. &lt;kbd&gt;Échap&lt;/kbd&gt; efface la mesure.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Faites glisser le long de quelque chose dont vous connaissez la longueur&#x202f;; tout le modèle suit. &lt;kbd&gt;Échap&lt;/kbd&gt; termine.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Tapez la longueur voulue&#x202f;; &lt;kbd&gt;Entrée&lt;/kbd&gt; redimensionne tout le modèle. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>Le modèle ne peut pas devenir aussi grand ou aussi petit.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>Le modèle ne peut pas être redimensionné à ce point&#xa0;: %1 dépasserait ses limites.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Cliquez sur la section qui sert de miroir&#x202f;; faites glisser pour tourner la vue. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B&#xa0;: en faire un cercle</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B&#xa0;: en faire une ellipse</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B&#xa0;: redresser ses lignes</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B&#xa0;: mettre les coins d’équerre</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B&#xa0;: éloigner sa fente du bord</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>C’est maintenant un cercle.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>C’est maintenant une ellipse.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Lignes redressées.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Coins mis d’équerre.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Éloignée du bord.</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 reste où elle a été dessinée&#xa0;: éloignée du bord, sa fente couperait %2 en morceaux. Dessinez en travers du bord, non le long.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Relâchez pour commencer %1 ici&#xa0;: %2&#xa0;%. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Relâchez pour finir %1 ici&#xa0;: %2&#xa0;%. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Faites glisser hors d’une section pour dessiner en travers à la plume&#x202f;; ici, pour tourner la vue. &lt;kbd&gt;Échap&lt;/kbd&gt; range la plume.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Faites glisser hors de %1 pour dessiner en travers à la plume&#x202f;; cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Cliquez pour placer le premier point, faites glisser pour courber. &lt;kbd&gt;Échap&lt;/kbd&gt; range la plume.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Cliquez pour placer un point, faites glisser pour courber&#x202f;; &lt;kbd&gt;Entrée&lt;/kbd&gt; ferme, &lt;kbd&gt;Retour arrière&lt;/kbd&gt; en retire un.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Cliquez pour placer un point, faites glisser pour courber&#x202f;; &lt;kbd&gt;Entrée&lt;/kbd&gt; ferme, &lt;kbd&gt;Retour arrière&lt;/kbd&gt; en retire un. Un clic avec &lt;kbd&gt;Ctrl&lt;/kbd&gt; ne s’accroche pas.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>Le contour se croise&#xa0;: &lt;kbd&gt;Entrée&lt;/kbd&gt; garde la plus grande boucle, &lt;kbd&gt;Retour arrière&lt;/kbd&gt; retire un point.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Faites glisser pour courber&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait un coin, &lt;kbd&gt;Maj&lt;/kbd&gt; garde la direction.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Faites glisser pour déplacer le point&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; n’accroche pas, &lt;kbd&gt;Maj&lt;/kbd&gt; garde la direction.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Faites glisser la poignée pour courber&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait un coin.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Cliquez pour fermer le contour&#x202f;; faites glisser pour déplacer le point.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Entrée&lt;/kbd&gt; place le point, &lt;kbd&gt;Tab&lt;/kbd&gt; passe au nombre suivant. &lt;kbd&gt;Échap&lt;/kbd&gt; ferme la barre.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Pas fermé&#xa0;: les points n’entourent encore rien.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Un contour est encore ouvert&#xa0;: &lt;kbd&gt;Entrée&lt;/kbd&gt; le ferme, &lt;kbd&gt;Échap&lt;/kbd&gt; le retire.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Jusqu’ici&#xa0;: %2. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Jusqu’ici&#xa0;: %2. &lt;kbd&gt;Entrée&lt;/kbd&gt; valide.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Entrée&lt;/kbd&gt; valide. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Relâchez pour le laisser ici. &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait un coin, &lt;kbd&gt;Maj&lt;/kbd&gt; garde la direction.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Relâchez pour garder ainsi. &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait un coin, &lt;kbd&gt;Maj&lt;/kbd&gt; garde la direction.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour garder ainsi. &lt;kbd&gt;Ctrl&lt;/kbd&gt; fait des coins à ses extrémités. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>Ici, le contour se croiserait lui-même&#x202f;; il reste comme il était juste avant.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Ici, un trou toucherait le bord ou un autre trou&#x202f;; il reste comme il était juste avant.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>Ici, %1 serait entièrement coupée au sol&#x202f;; elle reste comme elle était.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>Rien n’a été supprimé&#xa0;: un contour a besoin d’au moins deux points.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour sélectionner tout ce qui est entièrement à l’intérieur. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour sélectionner les points à l’intérieur. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 garde son angle avec %2. Libérez-la pour la tourner à votre guise.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 n’est pas sur une autre section&#xa0;: elle n’a donc d’angle avec aucune.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 ne peut pas être sur %2, qui est posée sur elle.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 et %2 ne se rencontrent pas&#xa0;: déplacez d’abord l’une en travers de l’autre.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Cliquez sur la section où poser %1. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Faites glisser pour tourner la vue&#x202f;; &lt;kbd&gt;Espace&lt;/kbd&gt; lance la lecture, &lt;kbd&gt;←&lt;/kbd&gt; et &lt;kbd&gt;→&lt;/kbd&gt; vont pas à pas. &lt;kbd&gt;Échap&lt;/kbd&gt; ferme les étapes.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>Le modèle a changé&#xa0;: la vue de ses étapes a été fermée.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Continuez de glisser pour sortir de %1&#x202f;; la fente finit à son bord. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Continuez de glisser pour sortir de %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; laisse la fente telle que vous la tracez. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>La vue tourne&#xa0;: continuez de dessiner, ou attendez qu’elle s’arrête.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Dessinez le contour&#xa0;: quittez la zone grise là où il doit commencer. Relâcher ici annule.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dessinez le contour, relâchez pour le fermer. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour faire la section. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour découper le trou dans %1. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour donner ce contour à %1. &lt;kbd&gt;Échap&lt;/kbd&gt; garde l’ancien.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour faire la section, en miroir par rapport à la fente. Tenez &lt;kbd&gt;Maj&lt;/kbd&gt; pour ne garder que ce côté. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour faire la section, en miroir. Lâchez &lt;kbd&gt;Maj&lt;/kbd&gt; pour ne garder que ce côté. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour donner ce contour à %1, en miroir par rapport à sa fente. &lt;kbd&gt;Maj&lt;/kbd&gt; fait l’inverse.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Relâchez&lt;/b&gt; pour faire la section, en miroir par rapport à la verticale. Tenez &lt;kbd&gt;Maj&lt;/kbd&gt; pour ne garder que ce côté.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Suivez la courbe bleu-vert pour vous accrocher à %1&#x202f;; tenez &lt;kbd&gt;Ctrl&lt;/kbd&gt; pour la quitter. &lt;kbd&gt;Maj+Entrée&lt;/kbd&gt; la prend en entier.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Maj+Entrée&#xa0;: prendre tout le guide</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>La fente ne touche aucun guide&#xa0;: il n’y en a donc pas à prendre en entier.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>Rien n’a été dessiné&#xa0;: la fente n’est jamais sortie de %1. Commencez à l’intérieur et faites glisser par-dessus son bord&#x202f;; &lt;kbd&gt;O&lt;/kbd&gt; dessine des trous, &lt;kbd&gt;E&lt;/kbd&gt; grave.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>Rien n’a été dessiné&#xa0;: la ligne est trop courte pour entourer quelque chose.</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Rien n’a été dessiné&#xa0;: une ligne de moins de %1 passe pour un faux mouvement, sauf si elle ferme une boucle.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>Rien n’a été dessiné&#xa0;: la ligne va et revient sans rien entourer.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>Rien n’a été dessiné&#xa0;: la ligne se croise, et aucune de ses boucles n’est assez grande.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 n’a pas été mise en miroir&#xa0;: les deux moitiés ne se rejoindraient pas.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>Le contour se croise lui-même&#x202f;; la plus grande boucle a été gardée.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 a été mise en miroir&#x202f;; ce qui traversait son axe et revenait a été omis.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 n’atteint pas sa fente&#xa0;: rien ne l’assemble avec %2.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 a été dessinée à côté de sa fente&#xa0;: elle a reçu une languette et a été coupée à plat au sol.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 a été dessinée à côté de sa fente et a reçu une languette qui y entre.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 n’est pas symétrique&#xa0;: ses moitiés diffèrent.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Faites glisser une flèche pour déplacer %1, un anneau pour le tourner, un carré pour le redimensionner&#x202f;; ou tapez des nombres. &lt;kbd&gt;Échap&lt;/kbd&gt; masque les poignées.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Faites glisser pour déplacer&#x202f;; &lt;kbd&gt;Maj&lt;/kbd&gt; garde une seule direction.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Faites glisser pour tourner.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Faites glisser pour redimensionner.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour garder ainsi. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 est verrouillé.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 ne peut pas être déplacé ou redimensionné à ce point.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Faites glisser le long de quelque chose dans %1 dont vous connaissez la longueur&#x202f;; &lt;kbd&gt;Maj&lt;/kbd&gt; se limite à huit directions. &lt;kbd&gt;Échap&lt;/kbd&gt; termine.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Tapez cette longueur&#x202f;; &lt;kbd&gt;Entrée&lt;/kbd&gt; donne cette taille à %1. &lt;kbd&gt;Échap&lt;/kbd&gt; efface la ligne.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Aucun morceau plan de %1 n’est assez grand pour une section&#xa0;: agrandissez-le d’abord.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Il a plus de %1 morceaux plans&#xa0;: choisissez moins de faces.</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Une plaque de %1 ne se plie pas&#xa0;: choisissez un matériau de %2 ou moins.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Pliez le long des lignes incisées, puis assemblez les bords de même numéro&#xa0;: %n jointure.</numerusform>
            <numerusform>Pliez le long des lignes incisées, puis assemblez les bords de même numéro&#xa0;: %n jointures.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Cliquez sur la section à déplacer ou à tourner, ou faites-la glisser. &lt;kbd&gt;Échap&lt;/kbd&gt; masque les poignées.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Faites glisser une flèche pour déplacer, un anneau pour tourner, un carré pour redimensionner&#x202f;; ou tapez des nombres. &lt;kbd&gt;Échap&lt;/kbd&gt; masque les poignées.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Faites glisser pour déplacer %1&#x202f;; cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Faites glisser pour déplacer&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; laisse une copie, &lt;kbd&gt;Maj&lt;/kbd&gt; garde une seule direction.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Faites glisser pour tourner&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; laisse une copie.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Faites glisser pour redimensionner&#x202f;; &lt;kbd&gt;Ctrl&lt;/kbd&gt; laisse une copie.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour garder ainsi. &lt;kbd&gt;Ctrl&lt;/kbd&gt; laisse une copie, &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Relâchez pour laisser une copie ici. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Entrée&lt;/kbd&gt; garde ainsi. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Entrée&lt;/kbd&gt; fait %n copie comme celle-ci. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</numerusform>
            <numerusform>&lt;kbd&gt;Entrée&lt;/kbd&gt; fait %n copies comme celle-ci, chacune un pas plus loin. &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Un préréglage doit avoir un nom, sans «&#x202f;=&#x202f;» ni espaces aux extrémités.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Les autres ne peuvent encore régler aucune valeur&#xa0;: il n’y a donc rien à garder.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>Il n’y a pas de préréglage nommé «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>Voilà ce que voient les autres. Enregistrez le fichier et donnez-le-leur&#x202f;; il s’ouvre ainsi.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n nombre qui en dépendait est maintenant un simple nombre.</numerusform>
            <numerusform>%n nombres qui en dépendaient sont maintenant de simples nombres.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>%n préréglage qui ne fixait rien d’autre disparaît avec elle.</numerusform>
            <numerusform>%n préréglages qui ne fixaient rien d’autre disparaissent avec elle.</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>Aucune plage plus étroite où le modèle tient n’a été trouvée.</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Bougez pour tourner la vue, relâchez pour arrêter.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Bougez pour déplacer la vue, relâchez pour arrêter.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Montez pour zoomer, descendez pour dézoomer&#x202f;; relâchez pour arrêter.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>Rien n’a changé&#xa0;: ce n’est pas possible ici.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 est verrouillée. Déverrouillez-la dans Structure pour la modifier.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 est faite par %2&#xa0;: modifiez sa source, ou détachez celle-ci.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>Il ne resterait rien de %1&#x202f;; elle reste comme elle était.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 a été coupée à plat au sol.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>Coupée à plat au sol, %1 s’est séparée en morceaux&#x202f;; le plus grand a été gardé.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>Rien n’a été collé&#xa0;: ce qui a été copié ne contient ni sections ni image.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>Rien n’a été copié&#xa0;: le modèle est déjà symétrique.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>Rien n’a été supprimé&#xa0;: un assemblage est là où deux sections se rencontrent. Supprimez l’une d’elles, ou choisissez le type «&#x202f;Aucun&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>« %1 » contient maintenant les réglages actuels, à la place des anciens.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Dessinez d’abord une section : il n’y a encore rien à refléter.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Dessinez d’abord une section : il n’y a encore rien à répéter ni à diviser.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n arête n’a pas de créneaux&#xa0;: ses plaques s’y rencontrent à un angle trop plat ou trop aigu, ou elle est trop courte. Moins de faces, ou plutôt des tranches, y remédient.</numerusform>
            <numerusform>%n arêtes n’ont pas de créneaux&#xa0;: leurs plaques s’y rencontrent à un angle trop plat ou trop aigu, ou elles sont trop courtes. Moins de faces, ou plutôt des tranches, y remédient.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ajoute l’image miroir de la sélection. &lt;kbd&gt;Entrée&lt;/kbd&gt; valide&#x202f;; &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ce que vous changez d’un côté change aussi de l’autre. &lt;kbd&gt;Entrée&lt;/kbd&gt; valide&#x202f;; &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rend les deux côtés identiques une fois&#x202f;; ensuite chacun est indépendant. &lt;kbd&gt;Entrée&lt;/kbd&gt; valide&#x202f;; &lt;kbd&gt;Échap&lt;/kbd&gt; annule.</translation>
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
        <translation>Verre d’eau</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Fourchette</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Couteau</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Cuillère</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Livre</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Pot de fleurs</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Une face a été omise&#xa0;: un de ses sommets n’existe pas.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>%n face a été omise&#xa0;: un de ses sommets n’existe pas.</numerusform>
            <numerusform>%n faces ont été omises&#xa0;: un de leurs sommets n’existe pas.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Une face a été omise&#xa0;: la position d’un sommet n’est pas un nombre.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>%n face a été omise&#xa0;: la position d’un sommet n’est pas un nombre.</numerusform>
            <numerusform>%n faces ont été omises&#xa0;: la position d’un sommet n’est pas un nombre.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Une face a été omise&#xa0;: elle a deux fois le même sommet.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>%n face a été omise&#xa0;: elle a deux fois le même sommet.</numerusform>
            <numerusform>%n faces ont été omises&#xa0;: elles ont deux fois le même sommet.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Une face a été omise&#xa0;: elle figure deux fois.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>%n face a été omise&#xa0;: elle figure deux fois.</numerusform>
            <numerusform>%n faces ont été omises&#xa0;: elles figurent deux fois.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Une face était tournée du mauvais côté et a été retournée.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n face était tournée du mauvais côté et a été retournée.</numerusform>
            <numerusform>%n faces étaient tournées du mauvais côté et ont été retournées.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>La surface a un trou&#xa0;: une arête est ouverte.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>La surface a des trous&#xa0;: %n arête est ouverte.</numerusform>
            <numerusform>La surface a des trous&#xa0;: %n arêtes sont ouvertes.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>Plus de deux faces se rencontrent à une arête.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>Plus de deux faces se rencontrent à %n arête.</numerusform>
            <numerusform>Plus de deux faces se rencontrent à %n arêtes.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>À une arête se rencontrent des faces qui ne peuvent pas être tournées du même côté.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>À %n arête se rencontrent des faces qui ne peuvent pas être tournées du même côté.</numerusform>
            <numerusform>À %n arêtes se rencontrent des faces qui ne peuvent pas être tournées du même côté.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>L’intérieur était à l’extérieur&#xa0;: tout a été retourné.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Un vide dans la coupe a été fermé par une courbe lisse.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n vide dans la coupe a été fermé par une courbe lisse.</numerusform>
            <numerusform>%n vides dans la coupe ont été fermés par des courbes lisses.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>Plan</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>Comment</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 ne dit pas sa taille en mm ou en pouces ; la chute est prise pour %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1 : le contour se croise lui-même ; son plus grand morceau est pris, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1 : des lignes coupent la chute en morceaux ; le plus grand est pris, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1 : des lignes dans la chute sont ouvertes ; ce qu’elles entoureraient une fois fermées reste libre.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Y compris les sections déjà là</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>Pas X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Pas Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Pas Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Réseau</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Répète des sections le long d’une ligne dans l’espace.</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>Réseau %1</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sections</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Cliquez sur les sections à répéter.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Interpole entre des sections.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>Transition %1</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Cliquez sur les sections de la transition, dans l’ordre.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Le long de</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Cliquez sur la section à longer.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Nombre par intervalle</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Placement</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Régulière</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>Douce aux bouts</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Correspondance</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Comme dessiné</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inversée</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Taille d’une copie</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Varier la taille ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Varier l’angle ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Plus petite</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramification</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Fait pousser, encore et encore, des copies d’une section et de tout ce qu’elle porte à la place de ses enfants.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>Ramification %1</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Racine</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Cliquez sur la section qui se ramifie.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Tenue par</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Cliquez sur la section qui la tient&#xa0;: les copies sont tenues de la même façon.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Enfants</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Cliquez sur les sections rattachées que des copies doivent remplacer.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Divise une section trop grande en cellules qui tiennent ensemble.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>Grille %1</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Cliquez sur la section à diviser.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Selon ma plaque</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellules</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Largeur de cellule</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Hauteur de cellule</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Bord</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Droit à connecteurs</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Puzzle</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bords</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Connecteurs par bord</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Taille des connecteurs</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Fusionner les restes de moins de</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vers l’avant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Vers l’arrière</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Même profondeur à l’intérieur</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>La même longueur de chaque copie se trouve dans l’autre section</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Rangée</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Répète une section en rangée le long d’une autre.</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>Rangée %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Engrenage</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Trous</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Secteur dessiné</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Secteurs</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Rayon extérieur</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Rayon intérieur</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Dent</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Ronde</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carrée</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapèze</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>Appliquer à</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>Cercle %1</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>Étoile %1</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>Trous %1</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>Rosace %1</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>Engrenage %1</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Fait d’une section un cercle, une étoile ou un engrenage, ou y découpe de tels trous.</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Cliquez sur la section à mettre en forme.</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Cliquez sur la section à répéter.</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Branche entière</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Avec tout ce qui y est rattaché</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Répéter selon</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Selon l’épaisseur locale</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Toute la section</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>Le long de la fente</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>Pas moins de</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Extérieur</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Intérieur</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Angle au bord</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>Tout le tour</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Pourtour</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Répète une section autour du contour d’une autre.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>Éventail %1</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Plans</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>en travers de X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>en travers de Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>en travers de Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>en travers de X et Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>en travers de X et Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>en travers de Y et Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>le long d’une courbe</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Tranches</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Par</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>Dans chaque direction</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>De tous les plans, en part de leur espacement</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Plus petit morceau</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>En mm²&#x202f;; les plus petits sont omis, ainsi que ceux qui sont minces partout</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Creux</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Il ne reste qu’une paroi le long du contour</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Coupe un maillage en sections qui suivent sa forme.</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Cliquez sur la section dont le contour sert de chemin.</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Cliquez sur les sections concernées.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>S’applique à</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Tout le modèle</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Répète d’un côté tout ce qui est dessiné de l’autre.</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Cliquez sur la section qui sert de miroir.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>Plan d’une section</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>Joindre au plan</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Répète tout autour d’un axe ce qui est dessiné une fois.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Cliquez sur les deux sections dont la fente est l’axe.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fente</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>comme une section</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>autour de Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>autour de X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>autour de Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Comme</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Cliquez sur la section à laquelle elles doivent être parallèles.</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>%1&#x202f;mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 makes nothing yet: choose its “%2”.</source>
        <extracomment>%1 is the name of an operation, %2 what it asks for: &quot;Along&quot;</extracomment>
        <translation>%1 ne produit encore rien&#xa0;: choisissez «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 a perdu sa section «&#x202f;%2&#x202f;», qui a été supprimée. Elle ne produit rien tant qu’une autre n’est pas choisie.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ne produit rien&#xa0;: ses sections ne se croisent pas.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ne produit rien&#xa0;: il n’y a pas de place dans sa plage.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 n’a rien à diviser&#xa0;: la section tient dans une seule cellule.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 n’a pas pu être calculée&#xa0;: ses sections manquent.</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 s’est arrêtée à 1 section.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 s’est arrêtée à %n section.</numerusform>
            <numerusform>%1 s’est arrêtée à %n sections.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 section de %1 a été omise, car rien ne la tient.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%n section de %1 a été omise, car rien ne la tient.</numerusform>
            <numerusform>%n sections de %1 ont été omises, car rien ne les tient.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 ne produit rien&#xa0;: son gabarit a disparu ou son fichier manque.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 petit morceau de %1 a été omis.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%n petit morceau de %1 a été omis.</numerusform>
            <numerusform>%n petits morceaux de %1 ont été omis.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1&#xa0;mm&#xa0;: imprimer à 100&#xa0;%</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Plaque %1, page %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
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
        <translation>Maj</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Méta</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Inser</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page préc.</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page suiv.</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bas</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Arrêté&#xa0;: %1. Le calcul reprend quand le modèle change.</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>Calcul impossible&#xa0;: %1. Raison&#xa0;: %2.</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>ce qu’on peut faire contre les problèmes</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Calcul&#xa0;: %1…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>Calcul&#xa0;: %1… %2&#xa0;%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>les assemblages et les fentes</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>les vérifications</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>l’ordre de montage</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>s’il tient</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>ce qu’il supporte quand les sections fléchissent</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>ce que supporte chaque endroit d’une section</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>la peau</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>la disposition des pièces sur les plaques</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>ce que les aimants font des gabarits</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>ce qui libère les pièces qui se bloquent</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>Régler la découpe</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Changer le matériau de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Changer le matériau de %n section</numerusform>
            <numerusform>Changer le matériau de %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Insérer %1</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Poser au sol</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Élargir la base de %1</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ajouter un pied à %1</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Assembler %1 et %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>Déplacer %1 vers %2</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>Déplacer %n section vers %1</numerusform>
            <numerusform>Déplacer %n sections vers %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Inverser les fentes de %1</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Déplacer %1 de %2</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Rendre montable</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Soutenir %1 par un pied</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Prolonger %1 jusqu’au sol</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>Prolonger %n section jusqu’au sol</numerusform>
            <numerusform>Prolonger %n sections jusqu’au sol</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>Donner à %1 une épaisseur de %2</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Tourner %1 à 90°</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Élargir %1 là où elle est fragile</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: inverser les fentes</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2&#xa0;: point de rencontre → %3&#xa0;%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: rétablir les réglages automatiques</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: type → mi-bois</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: type → mi-bois prolongé</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: type → mortaise</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: type → tenons</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2&#xa0;: type → aucun</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Raccourcir %1 à %2</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Redessiner %1</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dessiner un trou dans %1</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dessiner %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Vectoriser %1</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Changer la forme de %1</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>Poser %1 sur %2</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déplacer le poids sur %1</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Régler le poids à %1</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Renommer le poids en %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Retirer le poids</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Pousser %1</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déplacer la poussée sur %1</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Tourner la poussée sur %1</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Régler la poussée à %1</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Renommer la poussée en %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Retirer la poussée</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Répartir la charge sur %1</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Charger aussi les copies de %1</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ne pas charger les copies de %1</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Attirer les gabarits vers %1</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Attirer les gabarits vers %n section</numerusform>
            <numerusform>Attirer les gabarits vers %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Libérer les gabarits de %1</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Libérer les gabarits de %n section</numerusform>
            <numerusform>Libérer les gabarits de %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Marquer %1</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Modifier un marquage de %1</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Supprimer un marquage de %1</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Redimensionner le modèle à %1&#xa0;%</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Faire de %1 un cercle</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Faire de %1 une ellipse</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Faire du trou de %1 un cercle</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Faire du trou de %1 une ellipse</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Redresser des lignes de %1</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mettre d’équerre des coins de %1</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Éloigner %1 du bord</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ajouter un point à %1</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Supprimer un point de %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>Supprimer %n point de %1</numerusform>
            <numerusform>Supprimer %n points de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déplacer une poignée de %1</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Courber le contour de %1</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déplacer un point de %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>Déplacer %n point de %1</numerusform>
            <numerusform>Déplacer %n points de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Modifier un point de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>Modifier %n point de %1</numerusform>
            <numerusform>Modifier %n points de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déplacer %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>Déplacer %n section</numerusform>
            <numerusform>Déplacer %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Tourner %1</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>Tourner %n section</numerusform>
            <numerusform>Tourner %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Redimensionner %1</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>Redimensionner %n section</numerusform>
            <numerusform>Redimensionner %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Copier %1</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>Copier %n section</numerusform>
            <numerusform>Copier %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Copie en miroir de %1</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Copie en miroir de %n section</numerusform>
            <numerusform>Copies en miroir de %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mettre %1 d’équerre</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>Mettre %n section d’équerre</numerusform>
            <numerusform>Mettre %n sections d’équerre</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Aligner %1 sur un axe</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>Aligner %n section sur un axe</numerusform>
            <numerusform>Aligner %n sections sur un axe</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Poser %1 sur une autre section</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Libérer %1</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>Libérer %n section</numerusform>
            <numerusform>Libérer %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Rattacher %1</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>Rattacher %n section</numerusform>
            <numerusform>Rattacher %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Changer comment %1 suit</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Changer comment %n section suit</numerusform>
            <numerusform>Changer comment %n sections suivent</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Verrouiller %1</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>Verrouiller %n section</numerusform>
            <numerusform>Verrouiller %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Déverrouiller %1</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>Déverrouiller %n section</numerusform>
            <numerusform>Déverrouiller %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>Placer %1 sur sa plaque</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>Épingler %1</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>Épingler %n pièce</numerusform>
            <numerusform>Épingler %n pièces</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>Désépingler %1</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>Désépingler %n section</numerusform>
            <numerusform>Désépingler %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Désépingler toutes les pièces</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Changer la rotation de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Changer la rotation de %n section</numerusform>
            <numerusform>Changer la rotation de %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Garder %1 symétrique</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>Garder %n section symétrique</numerusform>
            <numerusform>Garder %n sections symétriques</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Laisser différer les moitiés de %1</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Laisser différer les moitiés de %n section</numerusform>
            <numerusform>Laisser différer les moitiés de %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ajouter le gabarit %1</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Retirer le gabarit %1</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Modifier le gabarit %1</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Déplacer le gabarit %1</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Tourner le gabarit %1</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Redimensionner le gabarit %1</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>Aligner %1 et %2</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Masquer le gabarit %1</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Afficher le gabarit %1</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Proposer %n section pour %1</numerusform>
            <numerusform>Proposer %n sections pour %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Faire des facettes de %1</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Déplier %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>Régler %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>Renommer %1 en %2</translation>
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
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Garder le préréglage %1</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Passer à %1</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Supprimer le préréglage %1</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Transmettre pour réglage</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Modifier la conception</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Régler les valeurs</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Resserrer les plages</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>Renommer %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Supprimer %n section</numerusform>
            <numerusform>Supprimer %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <extracomment>%1 is the name of an operation, %2 of what it works on (&quot;Along&quot;), %3 of a section</extracomment>
        <translation>%1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <extracomment>%1 is the name of an operation, %2 of a number (&quot;Count&quot;), %3 and %4 what it was and is</extracomment>
        <translation>%1&#xa0;: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Change %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Changer l’ordre de %1</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Exclure %1</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>Exclure %n section</numerusform>
            <numerusform>Exclure %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Ramener une section exclue</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Couper %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>Couper %n section</numerusform>
            <numerusform>Couper %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Coller %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>Coller %n section</numerusform>
            <numerusform>Coller %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Garder la cote</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Supprimer la cote</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Rendre symétrique</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Activer %1</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Désactiver %1</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Convertir %1</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Détacher %1</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Supprimer les trous de %1</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Supprimer les trous de %n section</numerusform>
            <numerusform>Supprimer les trous de %n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Décaler les plans de %1</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Modifier le nombre de plans de %1</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Modifier l’espacement des plans de %1</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 est trop petit ou trop mince pour des sections de %2 d’épaisseur.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Aucune section de %1 qui se tienne aux autres et reste debout n’a été trouvée.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Aucune autre section de %1 qui trouve sa place parmi celles déjà là n’a été trouvée.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Une seule section de %1 a été trouvée (%n)&#xa0;: toute autre la gênerait, ou ne serait tenue par aucune.</numerusform>
            <numerusform>Seulement %n sections de %1 ont été trouvées&#xa0;: toute autre les gênerait, ou ne serait tenue par aucune.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n section de %1 est le minimum trouvé pour tenir debout.</numerusform>
            <numerusform>%n sections de %1 sont le minimum trouvé pour tenir debout.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 a été enfoncé de %2 dans le sol, pour que ses sections reposent sur un pied plat.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 a été enfoncé de %2 dans le sol, et ses sections ont des pieds hauts de %3 au plus, pour tenir debout.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>Elle est animée&#x202f;; seule sa première image est montrée.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n texte a été omis.</numerusform>
            <numerusform>%n textes ont été omis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n image a été omise.</numerusform>
            <numerusform>%n images ont été omises.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Il manque un nombre, un nom ou un calcul.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Une expression a au plus %1 caractères&#x202f;; celle-ci est plus longue.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>À «&#x202f;%1&#x202f;», l’expression a plus de %2 nombres, noms et signes.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>À «&#x202f;%1&#x202f;», plus de %2 parenthèses ou signes sont imbriqués.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas être lu ici.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Il manque quelque chose après «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Il manque quelque chose avant «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Entre «&#x202f;%1&#x202f;» et «&#x202f;%2&#x202f;», il manque un signe, comme + ou *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>La parenthèse à «&#x202f;%1&#x202f;» n’est pas fermée.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Après «&#x202f;%1&#x202f;», il y a une parenthèse fermante de trop.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>Il manque un guillemet fermant au texte à «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>«&#x202f;%1&#x202f;» peut être un nombre ou deux&#xa0;: écrivez un point, ou une espace après la virgule.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>«&#x202f;%1&#x202f;» est une unité&#x202f;; il faut un nombre devant.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>«&#x202f;%1&#x202f;» peut se comprendre de deux façons&#xa0;: mettez «&#x202f;%2&#x202f;» entre parenthèses.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>«&#x202f;%1&#x202f;» est une seconde comparaison&#x202f;; and(…; …) en réunit deux.</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>Il n’y a pas de fonction nommée «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>«&#x202f;%1&#x202f;» prend %2 entre ses parenthèses, pas %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>«&#x202f;%1&#x202f;» prend au moins %2 entre ses parenthèses, pas %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>«&#x202f;%1&#x202f;» prend au plus %2 entre ses parenthèses, pas %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Il n’y a pas de valeur nommée «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>«&#x202f;%1&#x202f;» est l’épaisseur du matériau&#x202f;; ici, il n’y en a pas qu’un seul.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>«&#x202f;%1&#x202f;» est %2 et ne peut donc pas avoir sa propre unité.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>«&#x202f;%1&#x202f;» est %2 et «&#x202f;%3&#x202f;» est %4&#x202f;; on ne peut additionner ou comparer que ce qui est de même nature.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>«&#x202f;%1&#x202f;» est %2&#x202f;; on ne peut pas calculer avec.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>«&#x202f;%1&#x202f;» est %2&#x202f;; il faut ici %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>«&#x202f;%1&#x202f;» est %2&#x202f;; son exposant doit être un petit nombre entier, comme 2, et non «&#x202f;%3&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>«&#x202f;%1&#x202f;» multiplie trop de longueurs, d’angles ou de masses.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>«&#x202f;%1&#x202f;» est %2, qui n’a pas de racine carrée.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>«&#x202f;%1&#x202f;» vaut 0, et on ne peut pas diviser par 0.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>«&#x202f;%1&#x202f;» est négatif et n’a pas de racine carrée.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>La tangente de «&#x202f;%1&#x202f;» est infinie.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas entre −1 et 1&#xa0;: aucun angle n’y correspond.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas supérieur à 0, et on ne peut pas arrondir à un tel pas.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>«&#x202f;%1&#x202f;» est trop grand.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>«&#x202f;%1&#x202f;» vaut %2, ce n’est pas un nombre entier&#x202f;; round, floor ou ceil en font un.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>«&#x202f;%1&#x202f;» vaut %2&#x202f;; il faut au moins %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>«&#x202f;%1&#x202f;» vaut %2&#x202f;; il faut au plus %3.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>«&#x202f;%1&#x202f;» vaut «&#x202f;%2&#x202f;», qui ne fait pas partie des choix.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>«&#x202f;%1&#x202f;» donne un texte de plus de %2 caractères.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Cette valeur dépend d’elle-même&#xa0;: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Cette valeur dépend de «&#x202f;%1&#x202f;», qui n’en a pas en ce moment.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Deux valeurs s’appellent «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nom&#x202f;; un nom est une lettre, puis des lettres, des chiffres et _, %2 au plus.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas être un nom, car cela a un sens dans les expressions.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Cette valeur n’existe plus.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>L’accolade à «&#x202f;%1&#x202f;» n’est pas fermée.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>un simple nombre</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>une longueur</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>une surface</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volume</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un angle</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>une masse</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>un oui ou non</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>autre chose qu’une longueur, un angle, une masse ou un simple nombre</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Section %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Sections %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 et %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>Il n’y a pas de matériau «&#x202f;%1&#x202f;». Choisissez-en un du fichier, ou de la liste des matériaux, par exemple Birch plywood, Acrylic ou Card.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 ne laisse pas de place aux fentes dans le matériau %2&#xa0;: son jeu est de %3&#xa0;mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 ne convient pas au matériau %2, qui fait %3&#xa0;mm d’épaisseur.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>un fichier %1</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>un fichier %1 de %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>Utilisation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Affiche cette aide.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>Aucun fichier n’a été indiqué.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Trop de fichiers&#xa0;: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Donne à une valeur nommée du modèle un autre nombre, ou tout ce que fixe un préréglage&#x202f;; peut être répété.</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Épaisseur de chaque matériau.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Découpe toutes les sections dans ce matériau, ou dans celui d’un fichier .fff.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Largeur totale que la machine enlève.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Jeu ajouté aux fentes&#x202f;; moins de 0 pour un ajustement serré.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Indique l’endroit de chaque correction faite dans le fichier.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1&#xa0;: trouvé&#xa0;: «&#x202f;%2&#x202f;», attendu&#xa0;: %3.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1&#xa0;: trouvé&#xa0;: «&#x202f;%2&#x202f;», attendu&#xa0;: un nombre de %3 à %4.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: largeur x hauteur en mm, par exemple 600x400.</translation>
    </message>
    <message>
        <source>--set: %1</source>
        <translation>--set&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a file&apos;s name, %2 a sentence about what is in it
----------
%1 are names of stocks, %2 is a sentence</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Push all %1 slats together: what their width is less than %2 mm, divided by %1, is the kerf.</source>
        <translation>Serrez les %1 lattes ensemble&#xa0;: ce qui manque à leur largeur pour faire %2&#xa0;mm, divisé par %1, est le trait de coupe.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Attaches qui retiennent chaque pièce dans sa plaque, et leur largeur en mm, par exemple 3:0.4 (aucune).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Commence et finit chaque découpe à cette distance de sa ligne, dans la chute (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Découpe une seule fois les bords de deux pièces qui se touchent&#x202f;; avec --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Écrit une pièce d’essai à la place des pièces&#xa0;: des fentes de largeurs numérotées, et des lattes qui donnent le trait de coupe.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: un nombre de 0 à %2, puis un deux-points et une largeur de %3 à %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1&#xa0;: trouvé&#xa0;: «&#x202f;%2&#x202f;», attendu&#xa0;: un nombre de 0 à %3.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2&#xa0;mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Étape %1&#xa0;: commencer par la pièce %2</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Étape %1&#xa0;: commencer un groupe à part avec la pièce %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Étape %1&#xa0;: pièce %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Étape %1&#xa0;: pièces %2 d’un bloc, ce qui assemble ce qu’ont réuni les étapes %3 et %4</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Sections&#xa0;: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Assemblages&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 et %2 se rencontrent, mais aucune fente ne permet de les emboîter.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Toutes les sections tiennent ensemble.</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>une pièce de %1</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Non reliées au reste&#xa0;: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Taille %1 × %2 × %3&#xa0;mm (largeur, hauteur, profondeur)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Masse %1&#xa0;g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Matériau %1, %2&#xa0;mm, plaques de %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Pièce %1&#xa0;: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, assemblages %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>Rien à découper&#xa0;: le modèle n’a pas de sections.</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>Rien à découper&#xa0;: les fentes ne laissent rien d’aucune section.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>-o manque&#xa0;: indiquez le fichier à écrire.</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o&#xa0;: un fichier doit avoir un nom.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1&#xa0;: ce type de fichier ne peut pas être écrit&#x202f;; attendu&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Place à côté du modèle un maillage, une image ou un dessin (SVG), avec cette plus grande dimension en mm&#x202f;; peut être donné plusieurs fois.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: un fichier, ou un fichier et sa taille en mm, par exemple ball.stl@80.</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>Le fichier .fff à écrire&#x202f;; - est la sortie standard.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Met le maillage à cette plus grande dimension&#x202f;; sans cela, la taille qu’indique son fichier, sinon 254.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1&#xa0;: trouvé&#xa0;: «&#x202f;%2&#x202f;», attendu&#xa0;: un nombre entier de %3 à %4.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1&#xa0;: cet élément est trop grand pour la bande.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Longueur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Densité&#xa0;: %1&#xa0;%</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Pièces&#xa0;: %1, plaques&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2&#xa0;mm, %3&#xa0;: %4 pièces, couverte à %5&#xa0;%</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1&#xa0;: une pièce est trop grande pour sa plaque.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: groups ou files.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine&#xa0;: il n’y a pas de machine «&#x202f;%1&#x202f;»&#x202f;; attendu&#xa0;: %2, ou un fichier .json.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine&#xa0;: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files demande un nom&#xa0;: la sortie standard n’est qu’un seul fichier.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>Les fentes sont tracées avec une largeur de %1&#xa0;mm.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>Les fentes sont tracées avec une largeur de %1&#xa0;mm (%2 − %3 de trait de coupe).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Des plaques d’un export précédent sont encore là&#xa0;: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Pans&#xa0;: %1, triangles&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Endroits qui restent ouverts&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1&#xa0;: %2 m de découpe, environ %3&#xa0;min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>Les plaques sont plus grandes que son plateau de %1 x %2&#xa0;mm&#x202f;; choisissez-en d’autres avec --sheet.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Pièces&#xa0;: %1, plaques&#xa0;: %2, utilisation&#xa0;: %3&#xa0;%.</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>Le fichier à écrire&#x202f;; - est la sortie standard.</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1&#x202f;; nécessaire si le nom du fichier ne le dit pas.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Omet la barre de 100&#xa0;mm à côté des plaques.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Du bord de la plaque à la découpe la plus proche (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Entre découpes voisines (2).</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Seulement par quarts de tour, pour des plaques qui ont un fil.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Dispose les pièces d’après leurs vrais contours et cherche ce nombre de secondes&#x202f;; 0 prend la première disposition (d’après leurs rectangles).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups&#xa0;: un SVG avec un groupe par plaque&#x202f;; files&#xa0;: OUT-1.svg, OUT-2.svg, etc. (groups).</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>La machine qui découpe, pour ses couleurs, ses vitesses et son G-code&#xa0;: %1&#x202f;; ou un fichier .json avec la vôtre (generic).</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Écrit la forme que suggèrent les sections, comme une surface (%1), à la place des solides.</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Avec -o -, il manque le format&#xa0;: --format %1.</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin&#xa0;: ce type de fichier ne peut pas la contenir&#x202f;; attendu&#xa0;: %1.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon&#xa0;: ce type de fichier ne peut pas la contenir&#x202f;; attendu&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Pixels de l’image (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 à iso4, front, right, top, left, back, bottom, ou fit&#xa0;: de nouveau l’avant (iso1).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: largeur x hauteur en pixels jusqu’à %2, par exemple 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: l’un de %2.</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Tient debout.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Se renverse.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Se renverse&#xa0;: il ne repose que sur une seule ligne.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Une partie n’a rien sur quoi reposer.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>Il n’est pas au sol.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Glisse sur le sol.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>Ses parties bougent les unes par rapport aux autres.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Tient.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Tient tout juste&#xa0;: peut se fissurer dans un coin.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Casse.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Un assemblage se déboîte.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>La résistance n’est calculée que pour ce qui ne bouge pas.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Non évalué&#xa0;: la résistance d’un matériau n’est pas connue.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>On n’a pas pu calculer s’il tient.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Tiendrait debout %1.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Trop fragile&#xa0;: il tient, mais pas avec la sécurité demandée.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Tiendrait %1.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 appuie sur le sol avec %2&#xa0;N.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>L’assemblage %1–%2 est écarté par %3&#xa0;N&#xa0;: collez-le, ou inversez ses fentes.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>La flexion de %1 n’a pas pu être calculée&#x202f;; elle est traitée comme rigide.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>La flexion des sections n’a pas pu être calculée&#x202f;; elles sont traitées comme rigides.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Les assemblages peuvent se partager la charge de plusieurs façons (hyperstatique, %1)&#x202f;; la pire compte.</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>La contrainte dans %1 n’a pas pu être calculée.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 n’est pas évaluée&#xa0;: la résistance de son matériau n’est pas connue.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Une poussée de %1&#xa0;N tombe à côté de la matière de %2&#x202f;; l’endroit le plus proche la porte.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Un poids de %1 tombe à côté de la matière de %2&#x202f;; l’endroit le plus proche le porte.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 en tout</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1&#xa0;N en tout</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 fois la charge</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>Point le plus faible dans %1&#xa0;: %2 de la résistance de son matériau à l’étranglement, %3 dans le coin.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Fléchit de %1&#xa0;mm, surtout %2.</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Peut se fissurer à partir de %1.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Casse à %1.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Pèse %1&#xa0;N avec tout ce qu’il porte.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: NOM=VALEUR, par exemple width=400.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: NOM=VALEUR, par exemple width=400, ou un préréglage&#xa0;: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>«&#x202f;%1&#x202f;» peut être %2 ou %3&#x202f;; écrivez l’un des deux.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>le modèle n’a pas de valeurs nommées.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>il n’y a pas de valeur «&#x202f;%1&#x202f;»&#x202f;; attendu&#xa0;: %2.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Aucune valeur réglable par d’autres n’est à la fois utilisée et dotée d’une plage.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Essayé&#xa0;: %1 des %2 coins des plages, %3 variantes entre eux.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Toutes sont bonnes.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 sur %2 échouent&#xa0;:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Où&#xa0;:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Faces&#xa0;: %1, coques&#xa0;: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>Le plan ne le coupe pas.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Trou&#xa0;: %1&#xa0;mm², %2 points</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Boucle&#xa0;: %1&#xa0;mm², %2 points</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Surface&#xa0;: %1&#xa0;mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Un point du plan et sa normale, six nombres séparés par des virgules.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Met d’abord le maillage à cette plus grande dimension et le pose sur le sol.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Affiche du JSON, pour d’autres programmes.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>--plane manque.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: six nombres, dont les trois derniers sont une direction.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Pas de créneaux là où des plaques se rencontrent à moins de 30° ou à plus de 150°&#xa0;: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Pas de créneaux là où une plaque passe à côté de l’autre ou ne l’atteint pas&#xa0;: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Pas de créneaux sur les arêtes trop courtes pour en avoir trois&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Une plaque de %1&#xa0;mm ne se plie pas, attendu&#xa0;: au plus %2&#xa0;mm&#x202f;; --stock en choisit une autre.</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1&#xa0;: il a %2 morceaux plans, attendu&#xa0;: au plus %3&#x202f;; --faces en réduit le nombre.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1&#xa0;: aucun de ses morceaux plans n’est assez grand pour une section&#x202f;; --size l’agrandit.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Développés&#xa0;: %1, plis&#xa0;: %2, jointures&#xa0;: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Simplifie d’abord le maillage à ce nombre de triangles&#x202f;; ceux d’un même plan forment un seul morceau.</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Développés à plier le long de lignes incisées, en plaque jusqu’à 3&#xa0;mm, au lieu de plaques planes.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Avec --unfold&#xa0;: largeur des languettes à coller&#x202f;; 8&#xa0;mm pour une plaque jusqu’à 1,5&#xa0;mm, sinon 0&#xa0;mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap va avec --unfold.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Morceaux trop petits pour une section&#xa0;: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Sections&#xa0;: %1, assemblages&#xa0;: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Durée de la recherche (10)&#x202f;; 0 prend la première disposition.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Un autre nombre donne une autre disposition, le même donne la même.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Comment les pièces peuvent être tournées&#xa0;: none (pas du tout), 180, 90 ou free (librement).</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Du bord de la plaque à la découpe la plus proche.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Entre découpes voisines.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: none, 180, 90 ou free.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>Le modèle n’a pas d’opérations.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 section</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Affiche du JSON, pour d’autres programmes&#x202f;; les étapes sont comptées à partir de 0.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Plus grande distance entre cordes et courbes (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1&#xa0;: ce type de fichier ne peut pas être écrit&#x202f;; attendu&#xa0;: .png.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: labels, checks, stress, forces, skin, ou plusieurs séparés par des virgules.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1&#xa0;: aucune force n’est montrée&#x202f;; il ne tient pas debout, ou elles n’ont pas pu être calculées. «&#x202f;check&#x202f;» dit pourquoi.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>Le fichier PNG à écrire&#x202f;; - est la sortie standard.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels&#xa0;: les noms des sections&#x202f;; checks&#xa0;: entoure les sections qui ont un problème&#x202f;; stress&#xa0;: les coupes les plus faibles&#x202f;; forces&#xa0;: ce que portent pieds et assemblages&#x202f;; skin&#xa0;: la forme que suggèrent les sections.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Contrainte par éléments finis, en couleurs sur toutes les sections&#x202f;; prend quelques secondes.</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Une image nécessite un affichage avec OpenGL 3.3&#x202f;; il n’y en a pas.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>L’image n’a pas pu être écrite en fichier PNG.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>Le modèle de départ&#x202f;; sans lui, un nouveau.</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: X, Y, Z, XY, XZ, YZ ou radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>--count et --spacing ont été donnés tous les deux&#x202f;; attendu&#xa0;: un seul.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing&#xa0;: des plans autour d’un axe n’en ont pas&#x202f;; attendu&#xa0;: --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>Les axes que les plans coupent&#xa0;: X, Y, Z, deux d’entre eux pour une grille, ou radial&#xa0;: autour de l’axe vertical (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Plans dans chaque direction (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>D’un plan à l’autre.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1&#xa0;: aucun plan n’en coupe une section assez grande.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size sert pour .png&#x202f;; un PDF a la taille de son papier.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper sert pour .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: a4 ou letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Étape %1 sur %2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 ou letter (par défaut, selon l’usage de votre pays).</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Combien de sections (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Un autre nombre donne d’autres sections (1).</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Préréglages&#xa0;: %1. Actif&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Préréglages&#xa0;: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>Le modèle n’a pas de valeurs nommées.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Essaie les plages des valeurs réglables par d’autres.</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Un autre nombre essaie d’autres endroits, le même les mêmes.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>il y a plus de cellules que de noms.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2&#xa0;: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Un fichier CSV&#xa0;: des noms de valeurs, et une ligne de nombres par variante.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>Le dossier où écrire&#x202f;; il est créé s’il n’existe pas.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>Ce qui est écrit pour chacune (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>--table et -o sont nécessaires tous les deux.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format&#xa0;: trouvé&#xa0;: «&#x202f;%1&#x202f;», attendu&#xa0;: un type de fichier de découpe.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1&#xa0;: aucune ligne de nombres trouvée, attendu&#xa0;: une sous les noms.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1&#xa0;: un guillemet n’est pas fermé.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1&#xa0;: le dossier ne peut pas être créé.</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Pose un poids sur une section, en son milieu ou à X,Y en mm&#xa0;: «&#x202f;Nervure 4=350g&#x202f;», «&#x202f;Nervure 4@10,25=0.35kg&#x202f;». Peut être répété.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1&#xa0;: attendu&#xa0;: NOM=MASSE, par exemple «&#x202f;Nervure 4=350g&#x202f;».</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1&#xa0;: attendu après le =&#xa0;: une masse supérieure à 0 et d’au plus 1000000&#xa0;kg, en g, kg, oz ou lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1&#xa0;: il n’y a pas de section «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1&#xa0;: les fentes ne laissent rien de «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1 : deux colonnes s’appellent &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1 : ce type de fichier ne peut pas être écrit ; attendu : .pdf, .html ou .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size sert pour .png ; une page web s’adapte à son écran.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>Une image des étapes n’a pas pu être faite.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Un fichier PDF avec toutes les étapes (- est la sortie standard), OUT.html pour une page web où l’on peut tourner le modèle, aussi sur un téléphone, ou OUT.png pour OUT-01.png, OUT-02.png, etc.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut : autant de chutes du matériau %1, c’est trop.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Plaques de %1 qui manquent : %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Les étapes ne sont pas parmi les fichiers : %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Les plaques de %1 n’ont pas de place entre des marges de %2 mm.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut : « %1 » trouvé, largeur x hauteur en mm attendue, par exemple 300x200, ou un fichier .svg, suivie du nombre, par exemple :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Taille d’une plaque, par exemple 600x400 ; suivie de :N, combien il y en a.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1 : le modèle n’a pas de matériau « %2 » ; il est découpé dans %3.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1 : le modèle est découpé dans %2. Indiquez de quel matériau est celle-ci, comme dans « %3=%1 ».</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Une plaque d’un autre format, ou ce qui reste d’une plaque comme plus grand contour d’un fichier .svg en grandeur réelle, utilisée avant les plaques entières ; suivie de :N, autant d’entre elles. Pour un modèle de plusieurs matériaux, précédée du nom du matériau : « Birch plywood=300x200 ». Peut être répété.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Ne laisse que des parois de cette largeur le long des contours et là où d’autres croisent.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Grave les numéros de chaque assemblage dans une couleur à lui, la même sur les deux pièces.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours : ce type de fichier ne peut pas les contenir ; %1 attendu.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Découpé une seule fois pour deux pièces : %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>Aucun bord de deux pièces ne coïncide : rien n’est découpé une seule fois. Avec --spacing 0, les bords droits le peuvent.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>Les fentes %1 à %2 ont des jeux de %3 à %4 mm : enfoncez-y la bande, et donnez au matériau le jeu de celle qui va bien.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>Pas de place pour les entrées et sorties de toutes les découpes : %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>À propos de FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licences</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Pour signaler un bogue</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Dessinez des pièces planes en 3D, voyez aussitôt comment elles s’assemblent, et découpez-les. Le programme marche sans compte, et rien ne quitte cet ordinateur.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>D’après «&#x202f;FlatFitFab: Interactive Modeling with Planar Sections&#x202f;» de J. McCrae, N. Umetani et K. Singh (UIST 2014). Logiciel libre sous licence GNU General Public License, version 3 ou ultérieure.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Ce dont ce programme est fait</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Texte de la licence</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Ce programme</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Fenêtres, fichiers et texte</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Géométrie exacte</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Vecteurs et matrices</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Découpe et décalage de contours</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Lecture de dessins</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Décompression de dessins</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modèles avec images et maillages</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Éléments utilisés par CGAL</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Nombres sans arrondi</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Nombres à beaucoup de chiffres</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Résultats qui peuvent être des erreurs</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>Le modèle dans les pages web des étapes</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Point de vue</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Dessiner sur un plan</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Dessiner dessus</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Disposer</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Sélectionner</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Barre d’outils de réglage</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>à l’instant</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>il y a %n minute</numerusform>
            <numerusform>il y a %n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>il y a %n heure</numerusform>
            <numerusform>il y a %n heures</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>hier</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>il y a %n jour</numerusform>
            <numerusform>il y a %n jours</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Antérieur au dessin</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1&#xa0;: antérieur au dessin</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Verdicts</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>Supporte</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>Sans flexion</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>La section n’est pas là</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>Tel quel, il ne tient pas debout</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>Tel quel, il casse</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Résistance inconnue</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>calcul… %1&#xa0;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>calcul…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>calcul impossible</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Nombres de l’outil de dessin</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
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
        <translation>Longueur</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Hors plan</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copies</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Antérieur au dessin</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckWords</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Tips only past 12°.&quot;</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bon</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1 à %n endroit</numerusform>
            <numerusform>%1 à %n endroits</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>Les vérifications commencent avec la première section.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Antérieur au dessin</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Il n’y a pas encore de section à vérifier.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Aucun problème.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Vérification en cours&#x202f;; aucun problème jusqu’ici.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Problème %1 sur %2&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Vérification en cours. Ce sera fait dès que le résultat sera connu.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>Le modèle a changé&#x202f;; ce n’est plus possible.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Fait&#xa0;: %1.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Si vous cliquez&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>Problème %1 sur %2, endroit %3 sur %4&#xa0;: %5.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>Exporter vers</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Rechercher une commande</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Tapez ce que vous voulez faire</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Commandes trouvées</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Aucune commande trouvée</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Essayez un autre mot</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Écrire une pièce d’essai</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>Pièce d’essai %1</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Pièce d’essai écrite dans %1. Découpez-la et enfoncez la bande dans ses fentes&#x202f;; l’export demande laquelle allait bien.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1&#xa0;: sans jeu</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1&#xa0;: plus étroite de %2</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1&#xa0;: plus large de %2</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Attaches</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>Ce nombre de petites interruptions dans la découpe de chaque pièce la retient dans sa plaque&#x202f;; 0&#xa0;: aucune</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Largeur des attaches</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Amorce de découpe</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Chaque découpe commence et finit à cette distance de sa ligne, dans la chute&#x202f;; 0&#xa0;: sur la ligne</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>découper une fois</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Bords communs</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>Des pièces posées l’une contre l’autre, là où l’espacement est de 0</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Laquelle des fentes numérotées d’une pièce d’essai tient le mieux la plaque (à découper : menu Fichier, ou parmi les fichiers pour l’atelier). Elle règle le jeu.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Fente qui convient</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>environ %n min</numerusform>
            <numerusform>environ %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>Cotes</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Cote %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>Changer cette longueur redimensionne tout le modèle</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Changer cette longueur étire %1 entre les deux endroits</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Supprimer cette cote</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Ouvrir un modèle</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Insérer un modèle</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Importer un dessin</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Ajouter un gabarit</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>Rien n’a été inséré&#xa0;: %1 n’a pas de sections.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Enregistrer le modèle</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Enregistrer les modifications de %1&#x202f;?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Sans enregistrement, elles sont perdues.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Revenir à la version enregistrée</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 est tel qu’il était enregistré. Annuler ramène vos modifications.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Ouverture de %1…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Choisir un autre fichier</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Retirer de la liste</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Enregistrement de %1…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Enregistrer ailleurs…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Enregistré dans %1.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Modifié sur le disque</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 a été modifié par un autre programme.</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>L’écraser ferait perdre ces modifications.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sans titre</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Symétrie locale</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Mettre un contour en miroir par rapport à sa fente quand il est dessiné d’un seul côté. Maj fait l’inverse pendant le dessin.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Première en miroir</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Mettre aussi la première section en miroir, par rapport à la verticale passant par son début</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>Couper au sol</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Couper à plat au sol&#xa0;: omettre ce qui est dessiné dessous</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Accrochage</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>S’accrocher aux points, aux lignes d’alignement, au sol et à la grille</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>La vue tourne de</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>À 90°, vous regardez le nouveau plan bien en face&#x202f;; avec moins, la section de départ reste visible</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Durée de rotation</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Le temps que met la vue pour se tourner vers le plan d’une nouvelle section</translation>
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
        <translation>Un trou, pendant que vous le dessinez</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Un nouveau contour, pendant que vous le dessinez</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>Nouvelle section, pendant que vous la dessinez</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>Son contour vient ensuite</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fente</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>Sa propre fente</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>tenons</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermée</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>s’ouvre vers le haut, profondeur %1</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>s’ouvre vers le bas, profondeur %1</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>s’ouvre sur le côté, profondeur %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Sans miroir.&lt;/b&gt; Les deux moitiés ne se rejoindraient pas à la fente.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Sans miroir.&lt;/b&gt; Vous avez dessiné d’un côté de l’axe&#xa0;: %1 d’un côté, %2 de l’autre. La symétrie est désactivée, ou Maj est enfoncée.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;En miroir.&lt;/b&gt; Vous avez dessiné d’un côté de l’axe&#xa0;: %1 d’un côté, %2 de l’autre. Traversez-le de %3 ou plus pour dessiner vous-même les deux côtés.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Nouvelle section</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Suit</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Sur le guide</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1&#xa0;% du trait</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Écart maximal</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Un seul nombre à la fois peut suivre une valeur.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Ce nombre ne peut pas suivre une valeur.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Aucune. Cliquez sur une section pour l’exclure ou la détacher.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Réafficher</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>N° %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, exclue</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1, détachée</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>Exporter les fichiers de découpe</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Ouvrir ensuite le dossier</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Peau sur %1</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 en solides</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 sur %2 · %3 de découpe</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Exporter quand même</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Imbrication…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 et suivants, dans %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Remplace %1 dans %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>votre dossier personnel</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Plaque %1 sur %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Liste des pièces</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Plaque précédente (Page préc.)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Plaque suivante (Page suiv.)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>Montrer toute la plaque</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Une peau n’a pas de plaques&#xa0;: le fichier contient la forme que suggèrent les sections, comme une surface sur leurs contours.</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>Des solides n’ont pas de plaques&#xa0;: le fichier contient le modèle tel qu’il est monté, en grandeur réelle, avec ses fentes.</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Plaque %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Il n’y a rien à découper.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Utilisation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Disposition des pièces sur les plaques…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>Quel matériau&#x202f;?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Mesurer de nouveau</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Épaisseur mesurée</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Mesurez au pied à coulisse la plaque que vous allez découper&#xa0;: les fentes sont tracées pour elle.</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>Quelle plaque&#x202f;?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Largeur de la plaque</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Hauteur de la plaque</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, épaisseur %2</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Format libre</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>Quelle machine ?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Couleurs, calques, vitesses et G-code tels que cette machine et son programme les prennent, et ce qu’elle enlève de chaque matériau</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, mesuré %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>C’est ce que j’ai mesuré</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>%n chute est utilisée d’abord.</numerusform>
            <numerusform>%n chutes sont utilisées d’abord.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Laser quelconque</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Aucune pièce n’est sur une chute.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>%1 chute sur %n utilisée d’abord.</numerusform>
            <numerusform>%1 chutes sur %n utilisées d’abord.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2 fois</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>Impossible à découper</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Rien à surveiller.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Une plaque de %1 n’a pas de place entre des marges de %2.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>Le trait de coupe de %1 est de 0 : les fentes seront plus larges et les pièces plus petites de ce que la machine enlève.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>Les plaques dépassent le plateau de %1, qui mesure %2. Choisissez-en de plus petites.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Trait de coupe (total)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Jeu des fentes</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Fente tracée</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Marge au bord</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Quarts de tour pour une plaque qui a un fil</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100&#xa0;mm, sous les plaques</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Barre de mesure</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Tracée à côté des plaques, non découpée&#xa0;: mesurez-la sur votre machine pour vérifier l’échelle</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Découpes</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Angle libre</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Quarts de tour</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Demi-tours</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Comme dessiné</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Gardé pour ce matériau et la machine choisie</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>une couleur par assemblage</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Numéros d’assemblage</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>Les deux pièces d’un assemblage portent son numéro dans la même couleur : pour le papier, et pour les machines auxquelles on dit que faire de chaque couleur</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>Pas sûr ? Découpez d’abord une pièce d’essai…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>Les fentes de %1 n’en laissent rien. Elle n’est pas découpée.</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 est plus grande que la plaque. Elle est sur une plaque à sa taille.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 est trop fine pour porter son numéro.</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 a un trou ou une encoche plus étroits que le trait de coupe, qui ne sont pas découpés.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 n’a pas de place pour les numéros de tous ses assemblages.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n pièce</numerusform>
            <numerusform>%n pièces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n plaque</numerusform>
            <numerusform>%n plaques</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Export de %1…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>%1 sur %2&#xa0;: exporté dans %3.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>%1 sur %2&#xa0;: exporté dans %3&#x202f;; largeur tracée des fentes&#xa0;: %4.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>%1 sur %2&#xa0;: exporté dans %3&#x202f;; largeur tracée des fentes&#xa0;: %4 (%5 − %6 de trait de coupe).</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>%1 en solides&#xa0;: exporté dans %2.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Peau exportée dans %1&#x202f;; %n endroit reste ouvert.</numerusform>
            <numerusform>Peau exportée dans %1&#x202f;; %n endroits restent ouverts.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Peau exportée dans %1.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Matériaux…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Exporter ailleurs…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Des plaques d’un export précédent sont encore là&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>Rien n’a été exporté : les fichiers présents restent.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>Il faut %n plaque de %1 de plus qu’il n’y en a.</numerusform>
            <numerusform>Il faut %n plaques de %1 de plus qu’il n’y en a.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Il manque un nombre.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas être lu ici.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Il manque quelque chose après «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Une parenthèse n’est pas fermée.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>Il y a une parenthèse fermante de trop.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>On ne peut pas diviser par 0.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Il n’y a pas de valeur nommée «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>Ce n’est pas une longueur&#x202f;; multipliez une longueur par un simple nombre.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>Ce n’est pas une masse&#x202f;; multipliez une masse par un simple nombre.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>«&#x202f;t&#x202f;» est l’épaisseur du matériau&#x202f;; ici, il n’y en a pas qu’un seul.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>Rien n’a été ouvert&#xa0;: aucun fichier n’a été indiqué.</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 n’est pas un modèle. FlatFitFab ouvre %2.</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>%1 n’a pas pu être ouvert&#xa0;: il n’est plus dans %2. Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>%1 n’a pas pu être ouvert&#xa0;: %2. Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>%1 n’a pas pu être ouvert&#xa0;: %2 (%3). Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>Le fichier sur le disque est toujours l’ancien.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Rien n’a été écrit.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>le dossier %1 n’existe pas</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>Export impossible&#xa0;: %1. %2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>%1 n’a pas pu être enregistré&#xa0;: %2. %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>Déplacez un de ses points et il le sera</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Son centre, dans les coordonnées de la section</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Tourné de</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Trou %1</translation>
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
        <translation>Forme libre</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>Fichier de découpe</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Papier ou image</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Solides à imprimer ou visualiser</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Liste des pièces</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Tout pour un atelier</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>Quel fichier&#x202f;?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Pour quel usage&#x202f;?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Un fichier par plaque</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Vectoriser</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Repose sur</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Le coucher sur le sol</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Le mettre debout, vu de devant</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Le mettre debout, vu de droite</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Le coucher sur la section sélectionnée, qu’il suit</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Comme vu de derrière</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Aligner deux</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>Les deux dernières images comme vues de devant et de côté d’une même chose&#xa0;: de même hauteur et au-dessus du même endroit</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>À partir de quelle noirceur vectoriser</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>À quel point les coins s’arrondissent</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contours</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Faire des sections</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Des sections de ses contours, dans son propre plan</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Faire des trous</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Des trous dans la section sur laquelle il repose, ou qui est sélectionnée</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Graver</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Des lignes sur la section sur laquelle il repose, ou qui est sélectionnée</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1&#xa0;: trop nombreux pour des sections</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>se déboîte, %1&#xa0;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n assemblage se déboîte, jusqu’à %1&#x202f;N</numerusform>
            <numerusform>%n assemblages se déboîtent, jusqu’à %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modèles (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Dessins (%1)</translation>
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
        <translation>Droite</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Hors plan</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Copy: %1</source>
        <translation>Copie&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>Enregistrer les touches sur une page</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documents PDF (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>Touches de FlatFitFab</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>Impossible d’écrire %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Toutes les étapes&#x202f;; en choisir une y ramène.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Chaque étape figurera ici&#x202f;; vous pourrez revenir à n’importe laquelle.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>De retour au début. Cliquez sur une étape suivante pour la refaire.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>Le modèle est comme après «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Tel qu’ouvert</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Nouveau modèle</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Enregistré ici</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Suppr retire une section&#x202f;; glisser, ou Alt avec une flèche, change l’ordre.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (supprimée)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is what an operation works on (&quot;Along&quot;), %2 the name of a section</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::InstanceGroup</name>
    <message>
        <source>Made by an operation</source>
        <translation>Faite par une opération</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Faite par</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Image de</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>Exclure celle-ci</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>Faire de celle-ci une section dessinée&#x202f;; son opération continue de faire les autres</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Tirée de</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>Modifier l’une les modifie toutes</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>La redessiner&#x202f;; tout ce qui en est tiré suit</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Assemblage</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Fentes</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Rétablir les réglages automatiques</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sections</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>S’ouvre</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Inverser les fentes</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fente</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
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
        <translation>Point de rencontre</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>tenon, largeur %1</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>fermée, longueur %1, largeur %2</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>profondeur %1, largeur %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 et %2 se chevauchent.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Raccourcir %1</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Point de rencontre %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>La fente de %1 prend cette part de la profondeur, celle de %2 le reste</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Réglé à la main&#x202f;; l’automatique est 50&#xa0;%. %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Sections&#xa0;: %1 et %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Réglé à la main&#x202f;; le réglage automatique peut être rétabli</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 s’ouvre</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>Le côté où s’ouvre la fente de %1&#x202f;; celle de %2 s’ouvre de l’autre</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>Dans %1</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Laisser de nouveau le programme choisir le type, le sens et les points de rencontre</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>Rien n’est réglé à la main sur cet assemblage</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>Sélectionner l’assemblage avec %1</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Aucun pour l’instant</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>mi-bois</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>mi-bois prolongé</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>mortaise</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>tenons</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>aucun assemblage</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>Mi-bois</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>Mi-bois prolongé</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Mortaise</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Tenons</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>Le jeu de leur matériau ne laisse aucune largeur à une fente</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>Les fentes ne peuvent pas s’ouvrir vers l’extérieur&#xa0;: un trou est sur le passage</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>À un endroit elles ne coulisseraient que dans un sens, à un autre que dans l’autre</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Rien ne les retiendrait&#xa0;: il y a des trous là où les fentes commenceraient</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>Une section dépasse de l’autre, quel que soit le sens</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Aucune des sections ne dépasse de l’autre</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Elles se rencontrent à plusieurs endroits</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Aucune section ne passe par une fente fermée dans l’autre</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>Une section ne fait que finir contre l’autre</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Aucune section ne finit contre la face de l’autre</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>Il n’y a pas de place pour des tenons et leurs fentes</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Elles se rencontrent à moins de 30°</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Vers la droite</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Vers la gauche</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Vers le bas</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vers l’avant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Vers l’arrière</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Appuyez sur les touches</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>Les enregistrer sur une page à imprimer…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>Dans la vue</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>Dessiner la première section</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>glisser au milieu</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Dessiner une section en travers d’une autre</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>glisser hors d’elle, continuer</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Tourner la vue</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>glisser à côté du modèle</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Se rapprocher</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>glisser avec le bouton du milieu</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Sélectionner un groupe</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>Maj et glisser</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Voir ce qu’on peut en faire</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clic droit</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>double-clic sur le contour</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Dessiner sans accrochage</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>maintenir Ctrl</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Pièces dans les trous</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>Les petites pièces peuvent se placer dans les trous des grandes</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimètres</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
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
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Ajouter la sélection</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>Mettre la sélection dans la bibliothèque&#x202f;; sans sélection, tout le modèle</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>Choisir le dossier dont les modèles sont montrés ici</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>Les pièces que vous gardez apparaissent ici&#xa0;: sélectionnez des sections, puis cliquez sur Ajouter la sélection.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Dossier de la bibliothèque</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>Rien n’a été ajouté&#xa0;: rien n’est encore dessiné.</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>Le dossier de la bibliothèque %1 ne peut pas être créé.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 est maintenant dans la bibliothèque.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 est dans la corbeille.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>%1 n’a pas pu être mis à la corbeille.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Ajouter au modèle</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>Mettre à la corbeille</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadPage</name>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Point d’application</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Simple poids</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>Aussi en kg, oz ou lb&#xa0;: 1,5&#xa0;kg, 2&#xa0;lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Eau dedans</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Centre de gravité</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>Hauteur au-dessus de sa place&#xa0;: plus elle est grande, plus vite le modèle bascule</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10&#xa0;N, c’est à peu près ce que pèse 1&#xa0;kg</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Direction X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Direction Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Direction Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>Dans le plan de la section, à partir de son origine</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Position X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Position Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Répartition</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>En un point</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>Sur une surface</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Le long du bord</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Suspendu</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>Aussi sur les copies</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Les copies que des opérations font de sa section portent chacune la même charge</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Poids et poussées</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 renomme, Suppr retire.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Poussées</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#xa0;N</translation>
    </message>
</context>
<context>
    <name>fff::ui::MagnetGroup</name>
    <message>
        <source>Template</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Attiré</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Courber le gabarit jusque dans le plan de cette section, pour que les guides des autres suivent ce qui a été dessiné</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>À moins de</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Barre d’outils</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Répéter des sections et faire des transitions</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>Le modèle ne peut pas être montré&#xa0;: le pilote graphique n’offre pas OpenGL 3.3. Un pilote plus récent peut aider.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>Le modèle ne peut pas être montré sur cet affichage.</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Commencez un nouveau modèle, continuez-en un, ou regardez un exemple.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Récupéré&#xa0;: %n modèle non enregistré</numerusform>
            <numerusform>Récupéré&#xa0;: %n modèles non enregistrés</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Les afficher</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Récupéré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>L’ouvrir</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Afficher le dossier</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Ce modèle est là pour être réglé. «&#x202f;Modifier la conception&#x202f;» ramène tout.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Aide : %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Proposer des sections</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Combien</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Proposer</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Trouve des sections qui montrent sa forme, se tiennent entre elles et restent debout</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Une de plus</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Une section qui trouve sa place parmi celles déjà là</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>D’autres sections à la place des dernières</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facettes</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Faire des facettes</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>Le construit en plaques planes avec des créneaux le long des bords. Le maillage est d’abord simplifié à ce nombre de faces&#x202f;; celles d’un même plan forment une seule plaque.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Déplier</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>Le met à plat, pour le découper dans du carton en un ou quelques morceaux et le plier le long de lignes incisées. Les bords à assembler portent le même numéro.</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>Marquages</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Tourné de</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Marquage %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Gravé</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Incisé</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Supprimer ce marquage</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Hauteur des lettres</translation>
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
        <translation>%1&#xa0;kg</translation>
    </message>
    <message>
        <source>%1&#x202f;g</source>
        <translation>%1&#xa0;g</translation>
    </message>
    <message>
        <source>%1&#x202f;in²</source>
        <translation>%1 in²</translation>
    </message>
    <message>
        <source>%1&#x202f;cm²</source>
        <translation>%1 cm²</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeshImport</name>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 est trop grand pour un modèle&#xa0;: sa taille a été ramenée à %2. Elle se règle dans Gabarits.</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 ne connaît pas d’unité&#xa0;: sa taille a été fixée à %2. Elle se règle dans Gabarits.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Maillages, images et dessins (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Image collée</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>À l’échelle de %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Et %n autre.</numerusform>
            <numerusform>Et %n autres.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>rien de dessiné</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Nouvelles sections</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Matériau des prochaines sections dessinées</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Modifier le matériau</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>Montre, en l’amplifiant, où le modèle fléchit ou se défait. Rien n’est modifié.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>Les animations sont réduites&#xa0;: utilisez le curseur</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>On ne sait pas comment il bouge.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>Activez «&#x202f;Sections souples&#x202f;» pour voir comment il fléchit.</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Montré au moment où il commence à se défaire.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Fléchit de %1, montré %2 fois plus fort.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Fléchit de %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>Valeurs nommées</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Un nom est un mot de lettres et de chiffres, autre que «&#x202f;t&#x202f;» et les unités.</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Supprimer cette valeur</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Section %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>Au moins %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>Au plus %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Chute</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Une plaque d’une autre taille, utilisée avant les plaques entières</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>D’un dessin…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>Ce qui reste d’une plaque : le plus grand contour d’un fichier SVG en vraie grandeur, avec ses trous</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Largeur de la chute</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Hauteur de la chute</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Nombre de chutes pareilles</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Enlever cette chute</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, d’un dessin</translation>
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
        <translation>En choisir une autre</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>L’afficher</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>En permettre plus</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Garder ainsi</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Choisir</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Exceptions</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Convertir</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Faire des sections dessinées de ce qu’elle produit&#x202f;; l’opération elle-même disparaît</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>La supprimer avec tout ce qu’elle produit</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>En permettre plus</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Opérations, dans l’ordre</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 renomme, Espace masque et affiche, Alt avec une flèche change l’ordre.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Masquée&#xa0;: l’afficher</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>La masquer</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Filtrer par nom ou matériau</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sections</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 renomme, Espace masque et affiche.</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>Les sections apparaissent ici à mesure que vous les dessinez.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, en cours de dessin</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Verrouillée&#xa0;: la déverrouiller</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>La verrouiller</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Masquée&#xa0;: l’afficher</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>La masquer</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Dessinez une forme ici, bouton gauche enfoncé.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, et %n de plus ici</numerusform>
            <numerusform>%1, et %n de plus ici</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Calcul des fentes…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 depuis le dernier point</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>En miroir par rapport à la fente</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>En miroir par rapport à la verticale</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Coupée à plat au sol</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Sol à %1 sous ce bord</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Fente %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Fente %1, %2</translation>
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
        <translation>Tel qu’il découle des sections</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Réglé à la main</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Liste des pièces</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>Physique</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Visualisation</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Lignes de contrainte</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Montrer dès</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Part de la résistance de la plaque&#x202f;; en dessous, rien n’est montré</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>éléments finis</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Sections souples</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Quand des assemblages se partagent une charge, la rigidité des sections décide de la part de chacun. Prend un moment.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Carte de résistance</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Colore la section sélectionnée selon la masse que chaque endroit peut supporter, en plus de ce qui est déjà sur le modèle. Prend un moment.</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Points les plus faibles</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Charges</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Posez un poids sur le modèle pour voir ce qu’il supporte.</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Poids propre</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Au sol</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Ajouter un poids</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Ajouter une poussée</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Exigence</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Coefficient de sécurité</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>Combien de fois sa charge le modèle doit pouvoir porter pour que l’on dise qu’il tient</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Coefficient d’entaille, max.</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>L’augmentation de la contrainte dans les coins intérieurs dépend de la longueur de l’étranglement, jusqu’à ce coefficient&#x202f;; des fentes à bout rond en demandent moins</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>pendant des mois</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>Charge durable</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Un matériau supporte alors moins, selon son réglage&#xa0;: l’acrylique, un quart seulement</translation>
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
        <translation>Retirer cette poussée</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Retirer ce poids</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>calcul… %1&#xa0;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>calcul…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>calcul impossible</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>la section sélectionnée</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>sélectionnez une section</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Dessinez une section pour voir ce qu’elle supporte.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>On n’a pas pu calculer s’il tient.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Antérieur au dessin, calcul…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Il ne tient pas debout&#x202f;; aucune contrainte n’est montrée.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Un assemblage se déboîte&#x202f;; aucune contrainte n’est montrée.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Résistance inconnue&#xa0;: elle manque pour un matériau. Indiquez-la dans Matériaux.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>À jour. Les assemblages peuvent se partager la charge de bien des façons&#x202f;; la pire compte.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>À jour. Toutes les forces s’équilibrent.</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Fléchit de %2.</translation>
    </message>
    <message>
        <source>%1, %2: %3&#x202f;%</source>
        <extracomment>the name of a section, a place in it such as &quot;at its neck&quot;, a number of percent</extracomment>
        <translation>%1, %2&#xa0;: %3&#xa0;%</translation>
    </message>
</context>
<context>
    <name>fff::ui::PlaceGroup</name>
    <message>
        <source>across its slit</source>
        <translation>par rapport à sa fente</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>par rapport à la verticale</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>par rapport à l’horizontale</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>Elle ne suit pas la section qui la porte et ne garde pas son angle avec elle</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillée</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Elle reste comme elle est, sauf si la section qui la porte se déplace</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symétrique</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>Les modifications des points d’une moitié s’appliquent à l’autre</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Cliquez sur une autre section pour l’y poser</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>Pas sur une autre section</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Angle d’assemblage</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Suit</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>en proportion</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>son bout gauche</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>son bout droit</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>son bout inférieur</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>son bout supérieur</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Comment sa place suit quand une valeur étire la section qui la porte&#xa0;: autant que celle-ci s’étire à cet endroit, ou à sa distance d’un bout</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X de son milieu</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y de son milieu</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z de son milieu</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X de la direction vers laquelle elle est tournée, de longueur 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y de la direction vers laquelle elle est tournée, de longueur 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z de la direction vers laquelle elle est tournée, de longueur 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Orientation</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>Poignée avant</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Angle avant</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Poignée après</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Angle après</translation>
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
        <translation>Type</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisse</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symétrique</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>modifié</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nom du préréglage</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, quatre étagères…</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Garder les réglages actuels comme préréglage</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Supprimer ce préréglage</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Garder comme préréglage</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Donne aux réglages actuels un nom, par exemple A5, pour y revenir</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 en dehors</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 en dedans</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 trop haut</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>%n de plus dans Vérifications.</numerusform>
            <numerusform>%n de plus dans Vérifications.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Active</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Désactivée, elle ne produit rien mais garde ses réglages</translation>
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
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Rien n’est sélectionné</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Les modifications s’appliquent à toutes</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Elles se chevauchent</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automatique</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · réglé à la main</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n assemblage</numerusform>
            <numerusform>%n assemblages</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Faite par %1 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Section · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Section · sur %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · désactivée</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · ne produit rien</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · à jour</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (introuvable)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Vider cette liste</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Oublier ces noms&#x202f;; les fichiers restent</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>À surveiller</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Ferme ceci et le sélectionne dans le modèle</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Remplacer des fichiers</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>Remplacer %n fichier existant&#x202f;?</numerusform>
            <numerusform>Remplacer %n fichiers existants&#x202f;?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>Remplacer ce fichier&#x202f;?</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>Le long d’une nervure, d’un anneau à l’autre</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>Le long d’une nervure, jusqu’à l’anneau du bas</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Arche</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>décalage</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>axe_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>axe_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dos</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Traverse</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Traverses</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>Nervure du ventre</translation>
    </message>
    <message>
        <source>between</source>
        <translation>entre</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Tablette</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Tablettes</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>tablettes</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Branche</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>majuscule</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cases</translation>
    </message>
    <message>
        <source>column</source>
        <translation>colonne</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>colonnes</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Berceau</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>berceau</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Fronton</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Couverts</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profondeur</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diamètre</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>entraxe</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Cloison</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Cloisons</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Oreilles</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Socle du fond</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Danseur du fond</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Danseur du fond, penché</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Danseurs du fond</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Sapin</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Sapin en travers</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pied</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Pattes avant</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Fourchettes et petites cuillères</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Quatre tablettes</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>D’axe en axe, à l’horizontale</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>D’axe en axe, avec un peu de jeu</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>D’une paroi à l’autre</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Pied avant</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Pattes avant</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Traverse avant</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Vague avant</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Verre d’eau</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Poignée</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hauteur</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Hauteur des majuscules&#x202f;; un nom long doit être plus petit</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Hauteur des berceaux</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Hauteur de l’axe du pignon</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Hauteur de l’axe de la roue</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Pied arrière</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Pattes arrière</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Vague arrière</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Hanche</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Mandibules</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>Décalage d’une nervure à l’anneau du haut, par rapport à sa place en bas</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>De combien chaque nervure penche</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>De combien le pignon est plus bas, vu de la roue</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Largeur de la plaque, en hauteurs de majuscule</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Sa largeur</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Pots à épices</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Dernière nervure</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Patte gauche</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Feuille gauche</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Côté gauche</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Bande gauche</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Aile gauche</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Patte</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Pattes</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>pattes</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>lettres</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Pied long</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Anneau du bas</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Latte du bas</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Socle du milieu</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Danseur du milieu</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Danseur du milieu, penché</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Danseurs du milieu</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Nervure du milieu</translation>
    </message>
    <message>
        <source>module</source>
        <translation>module</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Mug</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Museau</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Plaque nominative</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Socle de devant</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Danseur de devant</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Danseur de devant, penché</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Danseurs de devant</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Cou</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>D’une nervure, dans sa longueur</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>Des tablettes, d’un bout à l’autre</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Du tiroir, à l’intérieur</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Du verre</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>De la paroi la plus haute</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Du pignon, depuis un creux face à la roue</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Du pignon, de même</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>Des côtés</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>Des côtés&#x202f;; le fronton monte plus haut</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>De la roue</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>De la roue, jusqu’au fond de ses creux</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>De la roue, jusqu’à la pointe de ses dents</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Autre pied</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Autre pile</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Autre main courante</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Autre semelle</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Autre orteil</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Stylos</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>phase</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>Pile</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Pignon</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>pignon</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Dents du pignon</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>pignon_rayon</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>pignon_pied</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>pignon_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque dorsale</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>plaque</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Plaques dorsales</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Main courante</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Rayon de nageoire</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Rayons de nageoire</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Nervure arrière</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>reste</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Nervure</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Nervures</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>nervures</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Patte droite</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Feuille droite</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Côté droit</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Bande droite</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Aile droite</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anneau</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Couronne de trous</translation>
    </message>
    <message>
        <source>root</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>row</source>
        <translation>rangée</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rangées</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>rangées</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Assise</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Tablette</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Épaule</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Côtés</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Semelle</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Taille des dents&#xa0;: le diamètre divisé par leur nombre</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Tranches</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Petit verre</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Épine dorsale</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Cuillères et couteaux</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Soleil</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Queue</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Dents</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>dents</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Dents du pignon</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>La même chose, sans les dents entières</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Trois tablettes</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>inclinaison</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Membrure</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>Membrures</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>Orteil</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Dent</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Tronc</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>Gobelet</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Rameau</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torsion</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Anneau du haut</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Latte du haut</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Vertèbres du cou</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Vertèbres de la queue</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Baleine</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>Ce qui tient sur une plaque de matériau</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Roue</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Où se trouve une dent de la roue</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Large</translation>
    </message>
    <message>
        <source>width</source>
        <translation>largeur</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>largeurs</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Poisson</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Teckel</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Sapin</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Abat-jour</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Chaise de poupée</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Porte-verre</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Organiseur de bureau</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Étagère</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Organiseur de tiroir</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Plaque nominative</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Support à verre</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Ours d’après un maillage</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Chouette d’après des images</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Hérisson en tranches</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Arêtes de poisson</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinosaure</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Lucane</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Arbre qui pousse</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Danseurs, deux poses</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Passerelle</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Engrenages</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Baleine en cellules</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Bonhomme à couverts</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Verre sur trois pieds</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Trois pieds fins&#xa0;: trop fragile</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Quatre pieds fins&#xa0;: trop fragile</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Trois pieds épais&#xa0;: tout juste</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Quatre pieds épais&#xa0;: sûr</translation>
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
        <translation>commencer créer vide vierge</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>charger importer flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>ajouter fusionner joindre combiner</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>sauvegarder sauver écrire</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>copier renommer</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>recharger abandonner</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>imprimer laser découper découpeuse cnc fraiseuse traceur svg dxf pdf gcode lightburn fabriquer</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>paramètres options réglages configurer sombre clair thème langue unités pouces souris navigation sauvegarde animation</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>touches clavier raccourcis</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>sortir quitter</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf importer</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf importer graver</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj image photo décalquer calque référence arrière-plan fond</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>retour défaire oups</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>refaire encore</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>presse-papiers</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>copier cloner</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>retourner refléter symétrique symétrie</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>effacer enlever corbeille</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>tout</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>chercher trouver palette</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoom centrer centre</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom centrer</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>face droit</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>orthographique isométrique parallèle caméra</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>transparent filaire travers</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>coupe intérieur moitié trancher</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>surface enveloppe coque</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>seul isoler</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>visible montrer réafficher</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>invisible cacher</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>grille plancher</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>partager donner personnaliser configurer élève classe ajuster curseurs verrouillé plein écran customizer</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>maximiser agrandir</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>barres latérales volets</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>disposition défaut</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>miroir moitié</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>plancher pieds base</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>aimanter magnétisme aligner guide</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>polygone ligne courbe bézier tracé</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>cercle carré rectangle polygone étoile</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>gravure texte lettres étiquette</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>bouger pivoter rotation échelle redimensionner</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>ouverture fenêtre découpe</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>remplacer</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>répéter motif ligne nervures côtes linéaire</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>tourner autour révolution</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>interpoler morphing dégradé lissage entre</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>arbre branche fourche</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>gaufre croisillons treillis</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>rayons roue engrenage polaire</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>tourner motif polaire</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>motif répéter copies</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>gaufre couches stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>transformer décomposer appliquer figer</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>erreur avertissement défaut</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>montage assemblage notice instructions animation lire</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>résistance casser simulation physique éléments finis</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>charge masse force</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>force charge</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>matière épaisseur contreplaqué acrylique saignée kerf</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>éprouvette test kerf saignée jeu fentes peigne</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>imbrication nesting placement disposer</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>longueur distance taille cote dimension</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>échelle taille redimensionner</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>manuel tutoriel documentation guide</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>accueil bienvenue exemples</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>version licence</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Assemblages</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Modifier le matériau</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Épaisseur du matériau&#xa0;: toutes les sections de ce matériau suivent</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Comme les autres</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Comment ses pièces peuvent être tournées sur la plaque&#xa0;: celle qui respecte le fil reste comme dessinée ou fait des demi-tours</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Une autre longueur étire le contour autour de sa fente, ou de son milieu</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Trous</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
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
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Groupes de préférences</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimètres (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centimètres (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Pouces (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>Pour l’affichage et la saisie. Les fichiers sont toujours en millimètres.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Prend effet au redémarrage.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Afficher la page d’accueil au démarrage</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Durée de rotation</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Le temps que met la vue, pendant le dessin, pour se tourner vers le nouveau plan. À 0, elle y saute.</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>La vue tourne de</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>À 90°, vous regardez le nouveau plan bien en face. Avec moins, la section de départ reste visible.</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>Les traits suivent un gabarit à moins de</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Boutons de souris comme dans</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Quels boutons tournent, déplacent et zooment la vue. Ctrl avec le bouton gauche la tourne toujours, Espace avec le bouton gauche la déplace.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Animations</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Toujours</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>Le moins possible</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Avec le moins possible, la vue saute au lieu de tourner.</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Couleurs de contrainte pour daltoniens</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>Du clair au foncé au lieu du bleu au rouge. Toujours ainsi en contraste élevé.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Avertir pour un angle inférieur à</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Plus l’angle entre deux sections est faible, plus leurs fentes doivent être larges.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Ignorer un chevauchement inférieur à</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Un chevauchement plus petit n’est pas un problème.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Chercher un ordre de montage pendant</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>En arrière-plan, après chaque modification. Accordez plus de temps si les vérifications ne trouvent pas d’ordre.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Coefficient de sécurité</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>Combien de fois sa charge un modèle doit supporter pour être jugé assez solide.</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Coefficient d’entaille, max.</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>Combien de fois plus élevée on suppose la contrainte dans les coins intérieurs.</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>Les charges durent des mois</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Sauvegarder le travail toutes les</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Après un plantage ou une coupure de courant, vous le retrouvez, même s’il n’a jamais été enregistré. Votre fichier n’est pas touché.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Garder la version précédente à l’enregistrement</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Fenêtre simple</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Pour dessiner, vérifier et exporter ; tout le reste disparaît.</translation>
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
        <translation>Panneau entier</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>Sur la plaque</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Position X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Tournée de</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>garde sa place</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Épinglée</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P épingle et désépingle la pièce sélectionnée parmi les plaques</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>trop grande pour une plaque</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, sa première pièce</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1&#xa0;mm, pour vérifier l’échelle</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Plaque, telle qu’elle sera découpée</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Plus et moins zooment, les flèches la déplacent, Origine la montre en entier.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>La chute %1 reste entière</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Plaques</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rapide</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bien</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Au mieux</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Avec quel soin les pièces sont disposées</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Rapide redispose toutes les pièces. Bien prend une dizaine de secondes. Au mieux continue jusqu’à ce que vous l’arrêtiez.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Diviser par Grille</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Tout désépingler</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Dessinez une section, et elle sera ici, prête à découper.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Imbrication…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Nouvelle imbrication…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n pièce épinglée n’avait plus de place où elle était.</numerusform>
            <numerusform>%n pièces épinglées n’avaient plus de place où elles étaient.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 est trop grande pour sa plaque.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 et %n autre sont trop grandes pour leurs plaques.</numerusform>
            <numerusform>%1 et %n autres sont trop grandes pour leurs plaques.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Ajouter une chute</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n plaque de plus qu’il n’y en a</numerusform>
            <numerusform>%n plaques de plus qu’il n’y en a</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · %2 de découpe</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>garde la meilleure jusqu’ici, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Imbrication… utilisation %1 %</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 sur %2 · utilisation %3 % · %4 de découpe</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Plaques, telles qu’elles seront découpées</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Page préc. et Page suiv. vont de pièce en pièce, les flèches déplacent une pièce de 1&#xa0;mm, R la tourne, P l’épingle. Plus et moins zooment, Origine montre toutes les plaques.</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · tournée de %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>Il n’y a pas de place pour elle.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>Elle ne peut pas être tournée d’aussi peu.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Elle reste comme dessinée.</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Plaque %1 sur %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>Trop grande</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>fil ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n pièce · utilisation %1&#xa0;%</numerusform>
            <numerusform> · %n pièces · utilisation %1&#xa0;%</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Chute, plaque %1 sur %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Épinglée : reste où elle est. Cliquez pour la désépingler.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Faites glisser une pièce ailleurs, ou cliquez dessus pour la sélectionner.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cliquez pour désépingler &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; est trop grande pour sa plaque. Cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Faites glisser &lt;b&gt;%1&lt;/b&gt; ailleurs, ou cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Faites glisser &lt;b&gt;%1&lt;/b&gt; ailleurs. &lt;kbd&gt;R&lt;/kbd&gt; la tourne, &lt;kbd&gt;P&lt;/kbd&gt; l’épingle.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtrer par nom ou touches</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Aucune touche pour cette commande</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>Les touches d’origine de cette commande</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout réinitialiser</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>Les touches d’origine de toutes les commandes</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>L’utiliser ici</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Commandes et leurs raccourcis</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Agit</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>dans la vue</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Choisissez une commande</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Touches pour %1&#xa0;:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Modifié par vous</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 seule gênerait la saisie. Tenez Ctrl ou Alt en même temps&#x202f;; les touches seules sont réservées aux commandes qui agissent dans la vue.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 appartient à «&#x202f;%2&#x202f;».</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Entre %1, elle se bomberait trop&#xa0;: une section de plus en travers dit jusqu’où.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Entre %1, elle se replierait sur elle-même.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Leurs contours ne disent pas ce qu’il y a entre %1.</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Peau&#xa0;: calcul… %1&#xa0;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Peau&#xa0;: calcul…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Peau&#xa0;: arrêtée</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Peau&#xa0;: calcul impossible</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Peau&#xa0;: rien à recouvrir</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Peau&#xa0;: aucun contour ne se croise</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Cliquez pour arrêter.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Une peau demande des sections qui se croisent et y finissent au même endroit.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n pan</numerusform>
            <numerusform>%n pans</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1&#x202f;; %n endroit reste ouvert.</numerusform>
            <numerusform>%1&#x202f;; %n endroits restent ouverts.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Cliquez pour revoir les sections seules.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Carré</translation>
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
        <translation>Bout de fente</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>Le bout intérieur d’une fente. Un laser le découpe carré&#x202f;; l’outil rond d’une fraiseuse ne peut pas atteindre ses coins. Rond&#xa0;: un fond rond au-delà du fond carré. Dogbone&#xa0;: un arc à travers chaque coin. T-bone&#xa0;: un arc dans chaque paroi&#x202f;; le fond reste plat.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Diamètre de la fraise. Les arcs sont tracés un peu plus grands, pour qu’elle puisse les suivre.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Un bout carré n’a pas d’outil. Pour une fraiseuse, choisissez un autre bout de fente.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Chanfrein d’entrée</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Chanfrein des deux parois à l’entrée d’une fente, à 45°, pour que les sections y glissent facilement. D’ordinaire de la moitié à toute l’épaisseur&#x202f;; 0&#xa0;: aucun.</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Bossages de serrage</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Hauteur d’un petit bossage sur chaque paroi d’une fente, qui serre la section glissée dedans. Elle doit dépasser la moitié du jeu&#x202f;; 0&#xa0;: aucun.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>section</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>section générée</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillée</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>a un problème</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>aucun problème</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Assemblage de %1 et %2</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, opération</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 sur %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n section sélectionnée</numerusform>
            <numerusform>%n sections sélectionnées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Page d’accueil</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Dessiner votre propre modèle</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Ouvrir un modèle, y compris de FlatFab</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Sans compte, rien ne quitte cet ordinateur.</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Afficher au démarrage</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>L’ouvrir</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Récupéré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Afficher le dossier</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>introuvable</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Retirer de cette liste</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>En ouvrir une copie</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Premier modèle en 3 minutes</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Dessiner, vérifier et découper un modèle, une étape à la fois</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>Ce que fait le prochain geste</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Nombre de sections</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Taille du modèle</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Masse du modèle</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Unité de toutes les longueurs</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>«&#x202f;%1&#x202f;» annulé.</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>«&#x202f;%1&#x202f;» annulé. &lt;kbd&gt;%2&lt;/kbd&gt; le ramène.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>«&#x202f;%1&#x202f;» rétabli.</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>«&#x202f;%1&#x202f;» rétabli. &lt;kbd&gt;%2&lt;/kbd&gt; l’annule.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Étapes du montage</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Exporter les étapes…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Fermer les étapes (Échap)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Étape précédente (Gauche)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Lire (Espace)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Étape suivante (Droite)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>Écarter les pièces</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Éclaté</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Espace)</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Écrire toutes les étapes dans un PDF à imprimer, une page web pour téléphones, ou une image de chacune</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Toutes les étapes, à imprimer (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Images, une par étape (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Exporter les étapes</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Export de %1…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>Rien n’a été écrit&#xa0;: l’export a été annulé.</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>Les étapes n’ont pas pu être exportées&#xa0;: aucune image ne peut être faite sur cet affichage.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n étape</numerusform>
            <numerusform>%n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>%1&#xa0;: exporté dans %2.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>%1&#xa0;: exporté dans %2 … %3.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Exporter ailleurs…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Page web (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>Ce navigateur n’affiche pas le modèle en 3D. Voici ce qu’il faut faire, étape par étape.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>Il n’y a pas d’images : aucune n’a pu être faite sur l’affichage de l’ordinateur qui a écrit cette page.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Glissez pour tourner le modèle, pincez ou utilisez la molette pour zoomer, touchez deux fois pour le voir en entier.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Étape précédente</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 pièce</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pièce</numerusform>
            <numerusform>%n pièces</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 plaque</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n plaque</numerusform>
            <numerusform>%n plaques</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 étape</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n étape</numerusform>
            <numerusform>%n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>Comment monter le modèle</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, de %2, en %3.</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>Les numéros sont ceux gravés sur les pièces. À chaque fente figure, après un petit trait, le numéro de son assemblage, le même sur ses deux pièces.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in %2.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;38 steps&quot;</extracomment>
        <translation>%1, en %2.</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsView</name>
    <message>
        <source>The model has changed, so its steps are not shown.</source>
        <translation>Le modèle a changé&#xa0;: ses étapes ne sont pas montrées.</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>Les étapes ne peuvent pas être montrées sur cet affichage.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>Les étapes ne seront pas montrées.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>Calcul de l’ordre de montage&#x202f;; les étapes seront montrées dès qu’il sera connu.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Les étapes ne peuvent pas être montrées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>L’ordre de montage est maintenant connu&#x202f;; «&#x202f;Afficher les étapes&#x202f;» le montre.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Il n’y a encore rien.&lt;/b&gt; Étape 1&#xa0;: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1:&lt;/b&gt; %2</source>
        <extracomment>%1 is &quot;Step 4 of 38&quot;, %2 what is done in it</extracomment>
        <translation>&lt;b&gt;%1&#xa0;:&lt;/b&gt; %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::Stock</name>
    <message>
        <source>Birch plywood</source>
        <translation>Contreplaqué de bouleau</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Contreplaqué de bouleau 4&#xa0;mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Contreplaqué de bouleau 6,5&#xa0;mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Contreplaqué de bouleau 9&#xa0;mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>Acrylique</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>Acrylique, transparent</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Acrylique, rouge</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Carton ondulé B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Carton ondulé C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Carton ondulé E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Carton</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Tilleul</translation>
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
        <translation>Utiliser %1 pour les nouvelles sections</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1&#xa0;: épaisseur %2 → %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Matériau de la prochaine section</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Matériau de la prochaine section&#xa0;: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Matériaux…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Matériaux</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Plaque L × H</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Masse volumique</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 signifie inconnu</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Prix d’une plaque</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Largeur de la plaque</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Hauteur de la plaque</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Plaques courantes</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Résistance</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Résistance en traction</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Résistance en flexion</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidité</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>avant de casser</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Se plie</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Comme le métal&#xa0;: au-delà de ces résistances, il reste plié</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Tient des mois</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Part de sa résistance sous une charge durable&#xa0;: l’acrylique flue et se craquelle</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Découpe</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Trait de coupe (total)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Jeu des fentes</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Fente tracée</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Fentes</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>non renseigné</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 signifie non renseigné</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>Aucune section n’est dans ce matériau</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>aucune&#xa0;: le trait de coupe est plus large que la fente</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Épaisseur, jeu et trait de coupe de deux sections de ce matériau d’équerre l’une sur l’autre</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Vendu comme</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>L’épaisseur sous laquelle on achète la plaque ; en général, elle n’est pas tout à fait celle-là</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>au pied à coulisse, par moi</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>L’export demande une fois l’épaisseur des plaques que vous allez couper</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>autant qu’il en faut</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 signifie autant qu’il en faut</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Combien il y en a</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Utilisées d’abord</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Une chute d’après un dessin</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Dessins (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Par machine</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Gardé là où un trait de coupe a été saisi pendant que cette machine était choisie à l’export</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Taille et nombre</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Matériaux de ce modèle</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Ajouter un matériau prédéfini</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Ajouter un matériau avec les mêmes nombres</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Enregistrer ce matériau dans un fichier, pour d’autres modèles et d’autres personnes</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Enregistrer le matériau dans un fichier</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Retirer le matériau</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Un modèle a besoin d’un matériau&#x202f;; ajoutez-en d’abord un autre</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Retirer ce matériau</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Depuis un fichier…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Ajouter un matériau depuis un fichier</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>Modèles FlatFitFab (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Faire sa %n section en</numerusform>
            <numerusform>Faire ses %n sections en</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Ajouter le matériau %1</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Retirer le matériau %1</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressCard</name>
    <message>
        <source>%1&#x202f;MPa, %2&#x202f;%</source>
        <extracomment>%1 is a stress in megapascals, %2 a number of percent</extracomment>
        <translation>%1&#xa0;MPa, %2&#xa0;%</translation>
    </message>
    <message>
        <source>In the neck</source>
        <translation>À l’étranglement</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>À son coin</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>Fléchi dans son plan</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Fléchi hors de son plan</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>Comprimé en long</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>Tiré en long</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Cisaillé</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Tordu</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>Si élancé qu’il peut flamber avant de casser.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Incertain&#xa0;: des forces agissent à côté des trous qu’il traverse.</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Chiffre approximatif&#xa0;: l’étranglement est trop court, ou trop près d’une force.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Il se fissurerait d’abord à son coin.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Il casserait droit en travers.</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#xa0;%</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressMarks</name>
    <message>
        <source>Stress</source>
        <translation>Contrainte</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Coefficient de sécurité %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Résistance inconnue</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Rien au-dessus de %1&#xa0;%</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>Mouvement %1 ×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Il ne tient pas debout&#x202f;; aucune contrainte n’est montrée.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Un assemblage se déboîte&#x202f;; aucune contrainte n’est montrée.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>On n’a pas pu calculer s’il tient.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Recherche de sections…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Création des facettes…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Dépliage…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>Vectorisation de %1…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>%n section faite.</numerusform>
            <numerusform>%n sections faites.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Sélectionnez d’abord la section à percer, ou posez le dessin dessus.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Sélectionnez d’abord la section à graver, ou posez le dessin dessus.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Recherche de plans…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>introuvable</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>relu à chaque fois</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>gardé dans le modèle</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Retrouver son fichier…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Le lire là où se trouve son fichier maintenant ; il reste à sa place</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Lier à son fichier…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>Ne plus le garder dans le fichier du modèle, qui devient plus petit, et le relire à chaque fois</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>Le garder dans le modèle</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>Le mettre dans le fichier du modèle, pour qu’il soit là sur d’autres ordinateurs</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>Le déplacer, le tourner et le redimensionner dans la vue, avec des poignées ou des nombres</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Par une ligne</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Tracer une ligne sur quelque chose dont vous connaissez la longueur</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Déplacer et tourner</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Gabarits</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Ajouter un gabarit…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Lire un maillage, une image ou un dessin d’après lequel dessiner des sections</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Ajoutez un maillage, une image ou un dessin, ou déposez-en ou collez-en un. Les sections que vous dessinez s’accrochent là où leur plan coupe un maillage, et aux lignes d’un dessin dans leur plan.</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 renomme, Espace masque, L verrouille, Suppr retire.</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Tranches…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>Le couper en sections qui le suivent</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Place et taille</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Encombrement</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Au sol</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Le poser sur le sol</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Mettre debout</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Le coucher sur l’autre côté&#xa0;: son haut est en haut dans la vue</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 est introuvable</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Déverrouiller</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
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
        <translation>X de son milieu</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y de son milieu</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z de son milieu</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Tourné autour de X, en premier</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Tourné autour de Y, après X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Tourné autour de Z, en dernier</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Maillage, %n triangle</numerusform>
            <numerusform>Maillage, %n triangles</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Image, %1 × %2 pixels</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Dessin, %n ligne</numerusform>
            <numerusform>Dessin, %n lignes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Passer cette étape</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Visite guidée, étape %1 sur %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Regardez autour.&lt;/b&gt; Faites glisser à côté du modèle pour le tourner ; la molette vous rapproche.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Découpez.&lt;/b&gt; &lt;b&gt;Exporter…&lt;/b&gt; montre les plaques et écrit le fichier pour la découpeuse.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Dessinez un corps.&lt;/b&gt; Appuyez au milieu de la vue et tracez son contour d’un seul trait, plat sur le dessus, jusqu’au sol.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Dessinez une section en travers.&lt;/b&gt; Appuyez dans le corps et franchissez son bord. Gardez le bouton enfoncé : la vue tourne. Tracez alors le contour, de nouveau jusqu’au sol.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Mesurez votre plaque.&lt;/b&gt; Cliquez sur le matériau à droite de la barre d’outils, puis sur son épaisseur, et saisissez ce que vous avez mesuré : toutes les fentes suivent.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;Est-ce que cela marchera ?&lt;/b&gt; Les pastilles au-dessus de la vue vous le disent. Cliquez sur l’une d’elles pour en savoir plus.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Répétez-la.&lt;/b&gt; Choisissez &lt;b&gt;Rangée&lt;/b&gt;, cliquez sur la section dessinée en travers, puis sur le corps : les copies se rangent le long de celui-ci.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Voilà tout le chemin,&lt;/b&gt; du premier trait au fichier. Ce qui est en rouge a des liens sous Vérifications pour le corriger. Appuyez sur &lt;b&gt;F1&lt;/b&gt; pour en savoir plus.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Presque.&lt;/b&gt; Ramenez la poignée ronde au bout de la rangée jusqu’à ce qu’aucune pastille ne soit rouge ; &lt;b&gt;Exporter…&lt;/b&gt; écrit alors le fichier pour la découpeuse.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;C’est bien petit.&lt;/b&gt; Annulez, puis dessinez en plus grand, sur environ la moitié de la largeur de la vue.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;La visite s’arrête ici.&lt;/b&gt; Vous pouvez la refaire depuis le menu &lt;b&gt;Aide&lt;/b&gt;. Appuyez sur &lt;b&gt;F1&lt;/b&gt; pour en savoir plus.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>Le travail non enregistré ne peut pas être sauvegardé en cas de plantage. Enregistrez-le pour plus de sûreté.</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Ce travail a été ouvert ou abandonné dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>La sauvegarde n’a pas pu être ouverte&#xa0;: %1.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sans titre</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n étape</numerusform>
            <numerusform>%n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Une copie d’un travail non enregistré vient d’un FlatFitFab plus récent&#x202f;; elle est gardée sous %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Une copie d’un travail non enregistré n’a pas pu être lue&#x202f;; elle est gardée sous %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Nombre entier</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Oui ou non</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Choix</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>small</source>
        <translation>petit</translation>
    </message>
    <message>
        <source>large</source>
        <translation>grand</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Choix</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>petit | grand</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Dépend de</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>titre au-dessus</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>à quoi elle sert</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Cela ne peut pas se lire comme ce qu’il faut ici.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>any</source>
        <translation>quelconque</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Réglable par d’autres</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Elle se règle là où la conception est transmise pour réglage</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>Ce qui en dépend devient de simples nombres</translation>
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
        <translation>Nom de la valeur</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Type, plage et note</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Seulement pour vous</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>La plage est maintenant plus étroite pour&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>%n variante essayée, et elle est bonne.</numerusform>
            <numerusform>Les %n variantes essayées sont toutes bonnes.</numerusform>
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
            <numerusform>Variantes en échec&#xa0;: %1 sur %n. %2.</numerusform>
            <numerusform>Variantes en échec&#xa0;: %1 sur %n. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>Sur %1 coins, %2 ont été essayés.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a value, %2 what it is: &quot;width 400 mm&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;width 400 mm, boards 6&quot;, %2 what is wrong there</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n other(s)</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Essai des plages… %1&#xa0;%</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Essayer toutes les plages</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Resserrer les plages</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Dit où, dans les plages des valeurs affichées, le modèle n’est pas montable, casse, se renverse ou ne tient pas sur la plaque.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nouvelle valeur</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>valeur</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Cette conception est faite pour être réglée&#xa0;: réglez ses valeurs, puis exportez-la. Faites glisser dans la vue pour la tourner.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>Elle est découpée dans %1.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>Il n’y a rien à régler dans cette conception.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Modifier la conception</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Transmettre pour réglage</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Ramener le dessin et tous les panneaux&#x202f;; enregistré maintenant, le fichier s’ouvre ainsi.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Qui ouvre le modèle enregistré voit la vue, les valeurs affichées et l’export, et rien d’autre.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Donnez un nom à un nombre : chaque champ peut l’utiliser, aussi dans des calculs comme = 2*jeu.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Comment le modèle est montré</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rayons X</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Cliquez pour revoir les sections telles qu’elles sont.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>En coupe</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Cliquez pour revoir tout le modèle.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>DESSUS</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>DESSOUS</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>AVANT</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>ARRIÈRE</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>DROITE</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>GAUCHE</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>Vue du modèle</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Dessinez avec le bouton gauche de la souris, tournez avec le droit.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 pour l’atelier</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Les étapes ne sont pas parmi les fichiers&#xa0;: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Où mettre le dossier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Le mettre ici</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>aucune image ne peut être faite sur cet affichage.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Dessine des pièces planes en 3D et les découpe.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modèles à ouvrir, chacun dans une fenêtre&#x202f;; dessins, maillages et images à ajouter à un nouveau.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Ouvre FILE comme copie&#xa0;: l’enregistrement demande un nom.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Joue un script d’appuis et de mouvements.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>SCRIPT</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Démarre sans tenir compte des préférences, et n’en garde aucune.</translation>
    </message>
</context>
</TS>
