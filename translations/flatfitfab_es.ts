<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n pieza</numerusform>
            <numerusform>%n piezas juntas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (pieza %2)</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (conjunto del paso %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>hacia arriba</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>hacia abajo</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>hacia la derecha</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>hacia la izquierda</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>hacia delante</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>hacia atrás</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>en el sentido de la flecha</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Todavía no hay ninguna sección, así que no hay pasos.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>De este modelo no se corta nada, así que no hay pasos.</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>No hay pasos que mostrar: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>No hay pasos que mostrar: no se encontró a tiempo el orden de montaje.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>No hay pasos que mostrar: el modelo no se puede montar, porque %n sección estorba.</numerusform>
            <numerusform>No hay pasos que mostrar: el modelo no se puede montar, porque %n secciones se estorban.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>No hay pasos que mostrar: el modelo no se puede montar, porque se estorban piezas de %1.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>No hay pasos que mostrar: el modelo no se puede montar, porque %1 se estorban.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Paso %1 de %2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>empieza con %1</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>empieza un grupo aparte con %1</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>pon %1 en su sitio</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>rodea la esquina con %1 y acaba moviendo %2</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>rodea la esquina con %1 y luego desliza %2 hasta encajar en %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>mueve %1 %2 hasta su sitio</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>desliza %1 %2 hasta encajar en %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Aguanta %1 más aquí antes de que %2 se agriete %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Aguanta %1 aquí antes de que %2 se agriete %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Aguanta %1 más aquí antes de caerse.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Aguanta %1 aquí antes de caerse.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Aguanta %1 más aquí antes de que se abra una unión.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Aguanta %1 aquí antes de que se abra una unión.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Aguanta más de %1 aquí.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>No se pudo calcular cuánto aguanta aquí.</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Ensanchar la base</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Añadir un pie</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Todo unido. De momento, solo una sección.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 unión</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n unión</numerusform>
            <numerusform>%n uniones</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Todo unido. Las dos secciones, mediante %1.</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Todo unido. Las %1 secciones, mediante %2.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Estaría todo unido %1.</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 no está unida al resto.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 no están unidas al resto.</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 se cruza con %2, pero nada las mantiene unidas.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 se cruzan con %2, pero nada las mantiene unidas.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Nada toca a %1. Está a %2 de %3.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Nada más toca a %1. Están a %2 de %3.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Eliminarla</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Eliminarlas</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Todo unido</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Estaría todo unido</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Sin unir</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Dibuja una sección que cruce las dos o acerca una a la otra.</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Aún sin unir</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>si se mantuviera unido</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>si nada se deshiciera</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>si el ancho de corte no cerrara ninguna ranura</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>si ninguna ranura fuera demasiado justa</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>si ninguna ranura fuera demasiado ancha</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>si no se plegara</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>si no resbalara</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>si nada se soltara</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>si no se abriera ninguna unión</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>si nada lo empujara</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>Terminar una en la otra</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>Terminar %1 en %2</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>Su unión está en «Ninguna».</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Ninguna ranura les permite encajar: la holgura negativa la deja sin ancho. Aumenta la holgura.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Ninguna ranura les permite encajar: en un sitio solo podrían deslizarse en un sentido y en otro, solo en el contrario. Acorta una de las dos.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Nada las sujetaría: hay agujeros donde empezarían las ranuras. Haz los agujeros más pequeños o deja que una termine dentro de la otra.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Ninguna ranura les permite encajar: ninguna de las dos llega al borde. Abre un agujero hacia fuera o deja que una atraviese la otra.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 y %2 se solapan a lo largo de %3. %4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>menos de %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 y %2 se solapan %3 fuera de sus ranuras.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 y %2 se solapan %3, pero no están unidas.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 y %2 están casi en el mismo plano: se cruzan a %3 y, por debajo de %4, ninguna ranura puede sujetarlas.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 y %2 se cruzan a %3; por debajo de %4, las ranuras se ensanchan.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Aparta una de ellas o haz que termine antes que la otra.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Secciones solapadas</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Ángulo demasiado pequeño</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Gira una de ellas para que el ángulo sea mayor.</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Unirlas</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Unirla con %1</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Unirlas con %1</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Llevarla a %1</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Llevarlas a %1</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Recortar %1</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Unir con lengüetas</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 no sujeta a %2: su ranura va por el borde y solo tiene material a un lado.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 no sujeta a %2: sus ranuras la cortan del todo por ahí.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 no sujeta a %2: su ranura tiene menos de %3 de profundidad.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 no sujeta a %2: su ranura no deja material a ningún lado.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 no sujeta a %2: otras ranuras quitan lo que iría dentro de la suya.</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Aparta la ranura del borde.</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Haz que una de las secciones que se cruzan ahí termine antes que las otras, o apártala.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>La ranura no sujeta nada</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>Las ranuras parten %1 en %2 piezas</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 sale en %2 piezas</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nada sujeta una de ellas, de %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nada las sujeta y la mayor mide %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1; nada sujeta %2 de ellas y la mayor mide %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>Las ranuras parten %1. Lo que se desprende queda unido, pero nada lo sujeta.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>Las ranuras parten %1. Nada sujeta lo que se desprende junto con %2.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>Las ranuras parten %1. Nada sujeta su pieza de %2 con %3.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Invertir las ranuras</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Piezas sueltas</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Apartar %1 del borde</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Apartar %1</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Hacer la ranura menos profunda</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>El ancho de corte de %2 cierra la ranura %1. Da más holgura a las ranuras del material o reduce el ancho de corte.</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>La ranura %1 es más estrecha que la fresa de %2. Da más holgura a las ranuras del material o elige una fresa más fina.</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Entre sus resaltes, las ranuras son %1 más estrechas que lo que entra en ellas. Es demasiado justo para cualquier material: haz los resaltes más pequeños.</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>Las ranuras son %1 más estrechas que lo que entra en ellas. Es demasiado justo para cualquier material.</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>Las ranuras son %1 más anchas que lo que entra en ellas, así que queda flojo.</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Cambiar la holgura</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Ranuras muy justas</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Ranuras muy anchas</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Ranura más estrecha que la fresa</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Mostrar la copia para un informe</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Sin calcular</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Se puede montar. De momento, solo una pieza.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Se puede montar. Pero nada sujeta una de las piezas.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Se puede montar. Pero nada sujeta %n de las piezas.</numerusform>
            <numerusform>Se puede montar. Pero nada sujeta %n de las piezas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Se puede montar. %n paso.</numerusform>
            <numerusform>Se puede montar. %n pasos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Se podría montar %1.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Aún no se puede montar. Se podría si dos secciones no se solaparan.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Aún no se puede montar. Se podría si %n par de secciones no se solapara.</numerusform>
            <numerusform>Aún no se puede montar. Se podría si %n pares de secciones no se solaparan.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Ver los pasos</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>Las secciones se estorban. %1 se cruzan en %2 que se deslizan en %3 direcciones distintas.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>Las secciones se estorban. %1 solo sale %2 de su ranura antes de chocar con %3.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>Las secciones se estorban. Ninguna de %1 se puede sacar en línea recta.</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Hacerlo montable</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>1 unión invertida.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>%n unión invertida.</numerusform>
            <numerusform>%n uniones invertidas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Orden no encontrado: %1.</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Orden no encontrado. La búsqueda tardó demasiado; eso no dice nada del modelo.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Se puede montar</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Se podría montar</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Aún no se puede montar</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>No se puede montar</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Acorta una de ellas o gírala para que se deslice en la misma dirección que las demás.</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Orden no encontrado</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Unión abierta. %3 N abren la unión entre %1 y %2.</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>No carga nada. %3 N abren la unión entre %1 y %2; las demás aguantan sin ella.</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Sujeto por fricción. De la unión entre %1 y %2 tiran %3 N, que solo aguanta un encaje justo.</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Unión abierta</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>No carga nada</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>Invertir sus ranuras</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Pégala.</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Sujeto por fricción</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Volcado por un empuje. Sin los empujes se tendría en pie.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Volcado por un empuje</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Dale una base más ancha o más peso, o empuja menos o más abajo.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 están unidas en anillo: móntalas en el orden de los pasos.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 están unidas en anillo: la última que entre tiene que deslizarse sobre otras dos a la vez.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Hay secciones unidas en %n anillo: móntalas en el orden de los pasos.</numerusform>
            <numerusform>Hay secciones unidas en %n anillos: móntalas en el orden de los pasos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Hay secciones unidas en %n anillo: la última que entre tiene que deslizarse sobre otras dos a la vez.</numerusform>
            <numerusform>Hay secciones unidas en %n anillos: la última que entre de cada uno tiene que deslizarse sobre otras dos a la vez.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>Unidas en anillo</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Sostenerlo con un pie</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 plancha</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n plancha</numerusform>
            <numerusform>%n planchas</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Cabe en la plancha. %1, %2 % aprovechado.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Cabe en la plancha. %1 de %2, %3 % aprovechado.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%1 piezas de %2 no caben en ninguna plancha de %3 con un margen de %4, se giren como se giren.</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 mide %2 y no cabe en ninguna plancha de %3 con un margen de %4, se gire como se gire.</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Elegir una plancha</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Cabe en la plancha</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>No cabe en la plancha</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Alargarlas hasta el suelo</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alargar %1 hasta el suelo</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Bajarlo al suelo</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Subirlo al suelo</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Se tiene en pie, pero cojea %1. Solo vuelca a partir de %2. Margen: %3.</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Se tiene en pie. Solo vuelca a partir de %1. Margen: %2.</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Se tiene en pie, inclinado %1. Solo vuelca a partir de %2. Margen: %3.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>El punto más bajo de %1 está a %2 del suelo.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>Los puntos más bajos de %1 están hasta a %2 del suelo.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Se inclina %1 hacia delante</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Se inclina %1 hacia atrás</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Se inclina %1 hacia su izquierda</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Se inclina %1 hacia su derecha</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Cojea %1: sus puntos más bajos no están todos en el suelo. Solo vuelca a partir de %2.</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1 hasta tenerse en pie: sus puntos más bajos no están todos en el suelo. Solo vuelca a partir de %2.</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Se tendría en pie %1. Solo volcaría a partir de %2. Margen: %3.</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Se cae con tocarlo: vuelca al inclinarlo %1. Margen: %2.</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Apenas se tiene en pie: vuelca al inclinarlo %1. Margen: %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Cojea</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Inclinado</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Se cae con tocarlo</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Vuelca fácilmente</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Se cae hacia delante. El centro de masas queda %1 por delante de los pies.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Se cae hacia atrás. El centro de masas queda %1 por detrás de los pies.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Se cae hacia su izquierda. El centro de masas queda %1 fuera de sus pies.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Se cae hacia su derecha. El centro de masas queda %1 fuera de sus pies.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Se cae. Todos sus pies están en una línea y nada lo mantiene derecho.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>No están en el suelo. Su punto más bajo queda %1 por encima.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>No está en el suelo. Su punto más bajo queda %1 por encima.</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Dale otro pie o lleva peso sobre los que tiene.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Únelo a lo que está en pie o llévalo al suelo.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Aún no se tiene en pie</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Aún no está en el suelo</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Se tiene en pie</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Se tendría en pie</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Haz que todos sus pies terminen a la misma altura.</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Se cae</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>No está en el suelo</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 veces la carga</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>su carga</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Aguanta</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Aguanta %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Aguantaría</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Aguantaría %1</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Puede agrietarse</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Aguanta por poco</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Puede agrietarse con %1</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Aguanta %1 por poco</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Se romperá</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Demasiado débil</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Se rompe con %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Demasiado débil para %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 se rompe %2 a partir de %3.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 puede agrietarse %2 a partir de %3;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>se rompe por lo más estrecho con %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>%1 se rompe por lo más estrecho con %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 puede agrietarse %2 a partir de %3.</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Con %1 se abre una unión.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Con %1 deja de tenerse en pie.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Aguantaría mucho más.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>No se pudo calcular cuánto aguantaría.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>No soporta ningún esfuerzo.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Lo más débil es %1, %2: a menos del 1 % de su resistencia.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>Lo más débil es %1, %2: al %3 % de su resistencia.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Se dobla %1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>La parte más estrecha de %1 trabaja al %2 % de su resistencia.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>Eso deja menos que el factor de seguridad de %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Resistencia desconocida. El material de %1 no tiene indicada ninguna resistencia.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Resistencia desconocida. No se pudieron calcular las fuerzas entre las secciones.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Resistencia desconocida. No se pudo calcular la tensión en %1.</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Resbala. Sus pies no resisten lo que lo empuja: empuja menos o dale más peso.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Se suelta. Nada mantiene %1 en su sitio: pega las uniones o añade otra.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Se pliega. Los dientes giran como bisagras y nada más impide que gire %1: pega las uniones o añade una con otra sección.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Fuera del material. Un peso en %1 cae fuera de su material; lo soporta el punto más cercano.</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Usa un material más grueso, ensánchala ahí o pon menos peso.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistencia desconocida</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Se suelta</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Se pliega</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Fuera del material</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Usar material de %1 de grosor</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Usar un material más grueso</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Indicar su resistencia</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Se deshace. %1 se sostiene con menos de lo que se puede cortar.</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Muy poco material. %1 solo tiene %2 de ancho en un punto.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Se deshace</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Ensánchala ahí o separa lo que se toca.</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Muy poco material</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Ensánchala ahí.</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: sus ranuras para %2 se juntan.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: no queda nada entre sus ranuras para %2.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: no queda nada entre su ranura para %2 y un agujero.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: no queda nada entre su ranura para %2 y su borde.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: solo quedan %2 de material entre sus ranuras para %3.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: solo quedan %2 de material entre su ranura para %3 y un agujero.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: solo quedan %2 de material entre su ranura para %3 y su borde.</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Bastante fino</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Ensancha la sección ahí o mueve la ranura.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Las ranuras se juntan</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Masa: %1. El centro de masas está a %2 del suelo.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 y %2 solo se tocan: se solapan menos de %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n par de secciones solo se toca: se solapa menos de %1.</numerusform>
            <numerusform>%n pares de secciones solo se tocan: se solapan menos de %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Solo se tocan</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar %1 a 90°</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Las ranuras desprenden de %1 una esquirla de menos de 1 mm². Es un sobrante y no lleva número.</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Las ranuras desprenden de %1 %n esquirla de menos de 1 mm². Es un sobrante y no lleva número.</numerusform>
            <numerusform>Las ranuras desprenden de %1 %n esquirlas de menos de 1 mm². Son sobrantes y no llevan número.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Sobrantes</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>Las ranuras de %1 la dividen en %2, que otras secciones mantienen unidas.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pieza</numerusform>
            <numerusform>%n piezas</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>Las ranuras de %1 no dejan nada de ella.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>%1 no se pudo cortar: no se pudo calcular qué dejan de ella sus ranuras. No se puede exportar nada; su masa cuenta sin ranuras.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 no se pudo calcular: le faltan secciones. No se puede exportar nada.</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Dividida por ranuras</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>No queda nada</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Sin cortar</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>La operación falló</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Ensancharla ahí</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n sección movida</numerusform>
            <numerusform>%n secciones movidas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n sección bajada %1</numerusform>
            <numerusform>%n secciones bajadas %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>%n sección subida %1</numerusform>
            <numerusform>%n secciones subidas %1</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>1 unión invertida</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>%n unión invertida</numerusform>
            <numerusform>%n uniones invertidas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 pasa a tener %2 de grosor</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>Las ranuras de 1 unión se encuentran en otro punto</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>Las ranuras de %n unión se encuentran en otro punto</numerusform>
            <numerusform>Las ranuras de %n uniones se encuentran en otro punto</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 movida %2</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1 girada %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>%n sección girada</numerusform>
            <numerusform>%n secciones giradas</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>una unión nueva con una ranura de %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 unión nueva</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n unión nueva</numerusform>
            <numerusform>%n uniones nuevas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 con otro contorno</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>%n sección con otro contorno</numerusform>
            <numerusform>%n secciones con otro contorno</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 añadida</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n sección añadida</numerusform>
            <numerusform>%n secciones añadidas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 eliminada</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n sección eliminada</numerusform>
            <numerusform>%n secciones eliminadas</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>no se parte nada más</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>1 problema resuelto</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n problema resuelto</numerusform>
            <numerusform>%n problemas resueltos</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>después: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>nuevo: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n aviso nuevo</numerusform>
            <numerusform>%n avisos nuevos</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>junto a su ranura para %1</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>donde se une a %1</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>en una esquina interior</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>en su parte más estrecha</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>Unidas en anillos</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>Dentro del suelo. %1 llega %2 por debajo.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>Dentro del suelo. %1 llegan hasta %2 por debajo.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>Dentro del suelo</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Desplazar los planos un %1 %</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>Un plano más en cada dirección</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Cabe en las planchas y los retales que hay.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>Como mucho %n plancha</numerusform>
            <numerusform>Como mucho %n planchas</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Cabe en la plancha. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Cabe en la plancha. %1 de %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Secciones un poco solapadas</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>Pueden faltar planchas. Hace falta hasta %n plancha de %1, y hay %2.</numerusform>
            <numerusform>Pueden faltar planchas. Hacen falta hasta %n planchas de %1, y hay %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>Pueden faltar planchas</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Mira en Planchas lo juntas que pueden ir las piezas.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Planos cada %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, desplazado un %2 %</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>Un plano más</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>Un plano menos en cada dirección</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>Un plano menos</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>Dos planos más en cada dirección</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>Dos planos más</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>Dos planos menos en cada dirección</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>Dos planos menos</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Ninguno de los desplazamientos y números de planos probados permite que se deslicen juntas. Convierte las rebanadas y acorta una de ellas, o quítala.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>El modelo está aquí para adaptarlo; «Editar el diseño» lo recupera todo</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Abrir un modelo, también de FlatFab</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>Insertar modelo…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insertar</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>Añadir a este modelo las secciones de otro</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>Plantilla para calcar…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Leer una malla, una imagen o un dibujo para dibujar secciones encima</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>Añadir a la biblioteca</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>A biblioteca</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>Guardar la selección en la biblioteca, para otros modelos</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Guardar el modelo</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Guardar el modelo con otro nombre</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Exportar archivos de corte…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>Escribir las piezas en un archivo para la cortadora láser</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exportar otra vez</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Exportar otra vez</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Escribir otra vez el mismo archivo, con las mismas opciones</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Volver a lo guardado</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Volver al modelo tal como está en su archivo; con Deshacer recuperas los cambios</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Preferencias…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Unidades, colores, idioma, archivos y atajos</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Atajos de teclado…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Ver qué hace cada tecla y elegir las tuyas</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Cerrar ventana</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Cerrar esta ventana; las demás siguen abiertas</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Cerrar todas las ventanas y el programa</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Ir a Propiedades</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Ir al primer campo de la selección; en la vista, Intro hace lo mismo</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Ocultar todos los paneles</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Sin paneles</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>Ocultar o mostrar los paneles laterales</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Pantalla completa</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Pantalla completa</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Llenar la pantalla con la ventana</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Restablecer la ventana</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Restablecer la ventana</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Devolver todos los paneles a su sitio original</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Zona siguiente de la ventana</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Zona siguiente</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Ir a la siguiente zona de la ventana: barra de herramientas, izquierda, vista, derecha</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Zona anterior de la ventana</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Zona anterior</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Volver a la zona anterior de la ventana</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>Problema siguiente</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Problema siguiente</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>Seleccionar las secciones del problema siguiente y mostrarlas</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>Problema anterior</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Problema anterior</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>Seleccionar las secciones del problema anterior</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Ver los pasos</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Mostrar paso a paso cómo se monta el modelo</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Materiales…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Materiales</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Materiales en plancha: grosor, resistencia, ancho de corte y tamaño de la plancha</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Pieza de prueba…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Prueba</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Escribir una pieza de prueba que indica qué ranuras encajan y qué ancho corta la máquina</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>Planchas</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Planchas</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>Mostrar las piezas en sus planchas, tal como se cortarán</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Ir a los valores</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>Cambiar los valores de los que salen los números del modelo</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Valor nuevo</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Un número con nombre, que aceptan los campos numéricos</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Buscar un comando…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Escribir para encontrar cualquier cosa que haga el programa</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Cómo se hace un modelo, paso a paso y con imágenes</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Modelos recientes y ejemplos</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>Acerca de FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Acerca de</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>Qué es este programa, su versión y sus licencias</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Todavía no se ha exportado</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Nunca se ha guardado</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>No ha cambiado nada desde que se guardó</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Mapa de resistencia</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Mapa de resistencia</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Colorear una sección según la masa que aguanta cada punto</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Selecciona antes la sección que quieres ver</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Selecciona antes una sección</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>No hay ninguna unión seleccionada: selecciona una sección y luego una de sus uniones</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>No hay ninguna otra sección</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>No hay ninguna operación seleccionada</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Todavía no hay ninguna sección</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>No hay ninguna sección seleccionada</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>Copiar las secciones seleccionadas y eliminarlas</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>Copiar las secciones seleccionadas, también para otras ventanas y programas</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>Añadir las secciones copiadas o una imagen para calcar</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>Poner al lado una copia de las secciones seleccionadas</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>Respecto a X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>Reflejar X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Poner una imagen reflejada de las secciones seleccionadas al otro lado del plano en que X es 0</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>Respecto a Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Reflejar Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Poner una imagen reflejada de las secciones seleccionadas al otro lado del plano en que Y es 0</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>Respecto a Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Reflejar Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Poner una imagen reflejada de las secciones seleccionadas al otro lado del plano en que Z es 0</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>Respecto a una sección…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Espejo</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Haz clic en una sección: al otro lado de ella aparece la imagen reflejada de las seleccionadas</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Secciones de SVG…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>De SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Una sección por cada contorno de un dibujo</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>Contorno de SVG…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Contorno SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>El contorno más grande de un dibujo en lugar del de la sección seleccionada</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>Agujeros de SVG…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Agujeros SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Un agujero de la sección seleccionada por cada contorno de un dibujo</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>Marcas de SVG…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Marcas SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>Las líneas de un dibujo, grabadas o rayadas en la sección seleccionada</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Dibujar una forma</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Arrastrar un círculo, un rectángulo u otra forma desde su centro</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>Con números: un agujero en la sección seleccionada o una sección aparte</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>Cápsula</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Cápsula</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Mover una plantilla</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Tiradores</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Mover, girar y escalar la plantilla con tiradores o números</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Escalar una plantilla con una línea</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Con una línea</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Dibujar una línea sobre la plantilla y decir cuánto mide</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>No hay ninguna imagen ni ningún dibujo: añade antes uno</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>No hay ninguna plantilla: añade antes una malla o una imagen</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Invertir las ranuras de la unión</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Invertir las ranuras</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>Hacer que las ranuras de la unión seleccionada se abran hacia el otro lado</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Restablecer lo automático</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Dejar que el programa vuelva a elegir el tipo, la dirección y los puntos de encuentro de la unión seleccionada</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>En esta unión no hay nada puesto a mano</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>Añadir peso</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Poner un peso en una sección para ver cuánto aguanta</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>Añadir empuje</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Empuje</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>Empujar una sección en un punto, o tirar de ella, para ver cuánto aguanta</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>Tirar de aquí</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tirar</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Tirar de una sección con el ratón para ver qué pasa; no se guarda nada</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Nada actúa sobre el modelo: añade antes un peso o un empuje</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>No hay ninguna malla que se pueda atraer</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Añadir texto o líneas para grabar</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Escribir o dibujar en una sección, para grabarlo o rayarlo</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>Lo próximo que se dibuje se graba</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>Rayar</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Rayar</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>Lo próximo que se dibuje se raya, para plegar o partir por ahí</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>Medir entre dos puntos; conservar la longitud o escalar el modelo según ella</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Escalar a una longitud</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Escalar a una longitud</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Dar una longitud y escalar el modelo para que coincida</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Conservar la longitud</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Seguir mostrando esta longitud</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Quitar esta cota</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Quitar esta cota</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>No hay nada medido</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>No hay ninguna cota elegida: haz clic en una con Medir</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>Reflejar…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>Reflejar las secciones seleccionadas o un lado del modelo en el otro</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Reflejar izquierda y derecha (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>Reflejar respecto al plano en que X es 0</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Reflejar arriba y abajo (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Reflejar respecto al plano en que Y es 0</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Reflejar delante y detrás (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Reflejar respecto al plano en que Z es 0</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>Reflejar respecto a una sección</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>Reflejar respecto al plano de la sección en la que hagas clic</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Copia reflejada</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Añadir una imagen reflejada de las secciones seleccionadas</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Mantener iguales los dos lados</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Ambos lados</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Reflejar todo lo dibujado a un lado, ahora y después</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Hacer simétrico una vez</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Una vez</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>Copiar un lado en el otro; los cambios posteriores no se copian</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Reflejar como se muestra</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Hacer lo que se muestra</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Elige antes Reflejar</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>Tomar la forma propuesta</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Forma propuesta</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Convertir lo recién dibujado en el círculo, la elipse, las líneas rectas o los ángulos rectos propuestos, o apartar su ranura del borde</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>Tomar la guía entera</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Tomar la guía</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>Hacer la sección con todo lo que su plano corta de una plantilla, agujeros incluidos</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>No hay nada propuesto para lo que acabas de dibujar</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>El plano en el que se dibuja no corta ninguna plantilla</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>Fila</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Fila</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>Repetir una sección en fila a lo largo de otra</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>Abanico por el contorno</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Abanico</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Repetir una sección alrededor del contorno de otra</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Transición</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transición</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Interpolar entre secciones</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>Ramas</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramas</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Hacer crecer copias de una sección a partir de ella misma, como un árbol</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Cuadrícula con conectores</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Dividir una sección que no cabe en la plancha</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>Contorno radial</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>Convertir una sección en un círculo, una estrella o un engranaje, o cortar en ella agujeros así</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>Espejo del modelo</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Repetir en un lado todo lo dibujado en el otro</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Simetría de rotación</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Repetir alrededor de un eje todo lo dibujado una vez</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>Repetir secciones a lo largo de una línea en el espacio</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>Rebanadas de una malla</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Rebanadas</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Cortar una malla que se calca en secciones que la siguen</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>Hacer simétrico ahora</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simétrico</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>Reflejar un lado en el otro, una sola vez</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>Activar o desactivar</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Activa</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>Desactivar la operación seleccionada o volver a activarla</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>Antes en el orden</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>Ejecutar la operación seleccionada antes que la de encima</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>Después en el orden</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>Ejecutar la operación seleccionada después de la de debajo</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>Convertir en secciones</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Convertir</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Convertir en secciones dibujadas lo que hace la operación seleccionada</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>No hay ninguna malla que rebanar: añade antes una</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>Ya es la primera</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>Ya es la última</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>Ajustar a puntos, líneas de alineación y cuadrícula</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Pluma</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Pluma</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Dibujar con clics en vez de con un solo trazo: poner puntos y arrastrar para curvar</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>No has escrito ningún número</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Quitar los agujeros</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Sin agujeros</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Cerrar todos los agujeros de las secciones seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Añadir punto</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Añadir punto</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Añadir un punto de control bajo el cursor o junto al seleccionado</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Eliminar punto</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Eliminar punto</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>Eliminar los puntos de control seleccionados</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Punto suave</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>Hacer suave el contorno en los puntos seleccionados</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>Punto simétrico</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>Hacer suave el contorno, con tiradores igual de largos a ambos lados</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Punto de esquina</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Convertir en esquinas los puntos seleccionados</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>No hay ningún punto de contorno seleccionado</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Selecciona una sección cuyo contorno se pueda editar</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>La selección no tiene agujeros</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Mover y girar</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Mover, girar y escalar con tiradores o números</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>Según los ejes globales</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Ejes globales</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Mover según los ejes globales y no en el plano de la sección</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Mover las secciones hijas</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Mover hijas</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Las secciones que se dibujaron en esta se mueven con ella</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Poner en otra sección…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Poner en</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Haz clic en la sección en la que quieres poner la seleccionada</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Liberar de su sección madre</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Liberar</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Desvincular de su sección madre: ya no se mueve con ella ni conserva su ángulo</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Poner en ángulo recto</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Ángulo recto</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>Girar la sección hasta que quede en ángulo recto con la sección en la que está</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>Alinear con el eje más cercano</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Alinear</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>Girar la sección para que mire en la dirección de un eje global</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>Proteger de cambios las secciones seleccionadas</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>Editar su origen</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Editar origen</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>Seleccionar la sección de la que sale la seleccionada</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>Separar esta</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>Convertir la sección seleccionada en una dibujada; su operación sigue haciendo las demás</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>Omitir esta</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>Omitir la sección seleccionada; su operación sigue haciendo las demás</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>La selección no está en otra sección</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>La selección la hace una operación</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>La selección no es simétrica</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>La selección está dibujada, no la hace una operación</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Seleccionar todas las secciones</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Seleccionar la siguiente</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>Seleccionar la sección siguiente</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Seleccionar la anterior</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>Seleccionar la sección anterior</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>Seleccionar las unidas</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Unidas</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Seleccionar todas las secciones unidas a las seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>Seleccionar las paralelas</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Paralelas</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Seleccionar todas las secciones paralelas a las seleccionadas</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Seleccionar mismo material</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Del mismo material</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Seleccionar todas las secciones del mismo material que las seleccionadas</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Nuevo</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuevo</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Empezar un modelo nuevo</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Deshacer el último paso</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>Rehacer el paso deshecho</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>Eliminar las secciones seleccionadas</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Poner un punto</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>No hay nada que deshacer</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Deshacer «%1»</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>No hay nada que rehacer</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Rehacer «%1»</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Soltar todas las piezas</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Soltar todas</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Dejar que todas las piezas vuelvan a moverse al colocarlas en las planchas</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>No hay ninguna pieza fijada a su plancha</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>Piel</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>Mostrar la forma que sugieren las secciones, como una superficie sobre ellas</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Simetría local</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Reflejar un contorno respecto a su ranura cuando se dibuja a un solo lado de ella</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Cortar a ras de suelo</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Cortar lo que se dibuja por debajo del suelo</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>En el suelo</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>En el suelo</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Dibujar una sección tumbada en el suelo</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>En el plano frontal</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>Frontal</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Dibujar una sección de pie en el centro, vista de frente</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>En el plano lateral</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Lateral</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Dibujar una sección de pie en el centro, vista de lado</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>Paralela a la sección</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Dibujar una sección paralela a la seleccionada</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Redibujar el contorno</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Redibujar</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Dibujar un contorno nuevo para la sección seleccionada</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>Dibujar un agujero</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Agujero</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>Dibujar un agujero en la sección seleccionada</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Bajar al suelo</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Posar el modelo en el suelo</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>El modelo ya está en el suelo</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Compartir para adaptar</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Compartir</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Quien abra el modelo guardado verá la vista, los valores mostrados y Exportar, y nada más</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Editar el diseño</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Los demás todavía no pueden adaptar ningún valor</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Mirar de frente</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Mirar desde arriba</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Mirar desde la derecha</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Mirar desde detrás</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Mirar desde abajo</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Mirar desde la izquierda</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Siguiente esquina</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Mirar desde la siguiente esquina</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Ver la sección de frente</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>De frente</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Mirar de frente la sección seleccionada</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Encuadrar todo</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Encuadrar</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Mostrar el modelo entero</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Encuadrar la selección</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Encuadrar la selección</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>Mostrar lo más grandes posible las secciones seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Vista anterior</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Volver a la vista anterior</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Perspectiva</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspectiva</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>Mostrar más pequeño lo que está más lejos, como lo ve el ojo</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Rayos X</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rayos X</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Ver a través de todas las secciones, hasta sus ranuras</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Solo la selección</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Aislar</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Atenuar todas las demás secciones</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>Ocultar las secciones seleccionadas</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>Volver a mostrar las secciones ocultas</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Vista en corte</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>En corte</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Cortar el modelo con un plano, para mirar dentro</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>Suelo y sombra</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>Mostrar el suelo con su cuadrícula y la sombra del modelo</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Líneas de tensión</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Tensión</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Mostrar dónde sufre más el modelo</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>No hay ninguna sección oculta</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>No hay ninguna vista anterior a esta</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>La ventana sencilla no lo tiene; en Preferencias está la completa</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Tu primer modelo en 3 minutos</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Dibujar, revisar y cortar un modelo paso a paso, en una ventana vacía</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Ayuda sobre lo que hay bajo el cursor</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Abre la ayuda donde habla de esta parte de la ventana</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>No reflejar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Dejar todo como estaba</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Imprime JSON, para otros programas.</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Secciones, uniones, tamaño y masa de un modelo</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Si se mantiene unido, se tiene en pie, se puede montar y cabe en la plancha</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Si es bastante resistente: fuerzas, tensión y lo que aguanta</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>Las piezas que hay que cortar, en las coordenadas de cada sección</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Una imagen del modelo; necesita pantalla</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Cómo se monta, paso a paso; necesita pantalla</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>Los valores con nombre de un modelo, y lo que sale de ellos</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Un archivo de corte y un veredicto por cada línea de una tabla de valores</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Todos los tipos de operaciones, o las operaciones de un modelo</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>Los contornos en los que un plano corta una malla</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Secciones que muestran una malla, se tienen en pie y se pueden montar</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Un modelo de una malla en rebanadas</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Un modelo de planchas planas con dientes en los bordes</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Las piezas bien juntas en planchas, o los elementos de una tira (.json)</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Reproduce un guion de lo que hace una persona en la ventana</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Las ranuras no dejan nada de ellas, así que no hay pieza: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>No caben en la plancha y van en planchas propias: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Demasiado delgadas para llevar un número: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Un agujero o una muesca más estrechos que el ancho de corte no se cortan: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>No hay sitio para los números de todas las uniones: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>No se pudo escribir la salida estándar.</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>No hay nada que revisar: el modelo no tiene secciones.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>Las secciones se doblan donde varias uniones comparten una carga, por elementos finitos; tarda segundos.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>La carga dura meses: cada material conserva solo su parte de resistencia para ese caso.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>No existe «%1».</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF con capas según el uso</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Versión de un archivo DXF: r2000 o r12 (r2000).</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>el propio modelo</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Milímetros por unidad de un archivo de FlatFab (25.4).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-code para láser</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>un proyecto de LightBurn</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>los sólidos en su sitio</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>la lista de piezas</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF a tamaño real</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Páginas de un archivo PDF: sheet (una por plancha), o repartidas en a4 o letter (sheet).</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>una imagen de las planchas</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Cómo quedan las piezas en un archivo STL o 3MF: in-place (en su sitio), o flat (tumbadas en sus planchas) (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>las piezas para imprimir</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>archivos de corte, a tamaño real</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>todo para un taller</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>no hay pantalla con OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>La búsqueda se detuvo antes de terminar porque este equipo está ocupado: otra ejecución puede dar otra disposición.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Ranuras para probar</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Tira para encajar</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Listón para medir</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Demasiado cerca del borde: la ranura no sujetaría nada</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Demasiado cerca del borde: la ranura no sujetaría nada. B: apartarla</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Apartada %1 del borde. B: dejarla como estaba</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>vertical</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>en ángulo recto con el borde</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>paralela a la anterior</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Girando…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Dibuja el contorno</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Aún sin unir</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>«%1» da %2, que aquí no es posible.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>«%1» y otra expresión piden a la vez valores distintos aquí.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Aquello a lo que pertenece este número ya no existe.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Cota</translation>
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
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>X del centro</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>Y del centro</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>Altura de las letras</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Holgura</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Ancho de corte</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Ancho de una plancha</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Alto de una plancha</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Diámetro de la fresa</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Chaflán de las ranuras</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Resaltes de las ranuras</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Lleno de</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Fuerza según X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Fuerza según Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Fuerza transversal</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Punto de encuentro</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>«%1» no es posible aquí: los números que siguen valores lo mantienen en %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>«%1» no es posible aquí: %2 sigue a «%3», que lo deja como está.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>«%1» no se puede calcular.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>«%1» está vacío, y eso aquí no es posible.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>no hay memoria suficiente</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>una malla: esto es plano</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>bytes</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>entradas</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>su índice de contenido está dañado</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>esta entrada está dañada</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>esta entrada está cifrada</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>en este archivo hay más que su contenido</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>esta entrada aparece dos veces</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>esta entrada está comprimida de un modo desconocido</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>esta entrada tiene otro nombre en el índice de contenido</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>dentro hay entradas que comparten sus bytes</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>esta entrada ocupa demasiado al descomprimirse</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>datos gzip sin daños</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>el resto de los datos gzip</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>una plancha más grande</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>un archivo necesita un nombre</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>este archivo es de solo lectura</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>esta carpeta es de solo lectura</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>un modelo</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>este valor no se permite aquí</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>no se encontró nada, se esperaba %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>se encontró «%1», se esperaba %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>esta cantidad no es posible</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>se encontró una cantidad de %1, se esperaba como máximo %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>se encontraron %1 %3, se esperaban como máximo %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>hecho con un FlatFitFab más nuevo</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>hecho con un FlatFitFab más nuevo: se encontró el formato %1, se esperaba como máximo el %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>estos puntos de control no forman un contorno cerrado</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>estos puntos de control no forman un contorno cerrado: se encontró %1, se esperaba %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>ningún camino puede seguir todo este contorno a medio ancho de corte</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>ningún camino puede seguir todo %1 a la mitad del ancho de corte de %2 mm; suaviza los detalles más finos de su contorno o da a su material otro ancho de corte</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>el ancho de corte cierra una ranura</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 tiene una ranura de %2 mm de ancho, que un ancho de corte de %3 mm cerraría</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>un archivo %1</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>un archivo %1 de %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>no se pudo abrir</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>no se pudo escribir</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>no es un modelo, se esperaba %1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>el archivo termina aquí, se esperaba %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>el archivo termina demasiado pronto</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>se encontró «%1», se esperaba un número finito</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>un número no es finito</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>estos ejes no forman un sistema de coordenadas, se esperaban dos de longitud 1 en ángulo recto</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>este contorno no encierra ninguna superficie</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>no hay nada con el número %1</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>hace referencia a algo que no existe</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>el número %1 se usa dos veces, se esperaba uno propio</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>este número se usa dos veces, se esperaba uno propio</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>estas dos secciones son casi paralelas y no se pueden unir</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>este contorno se cruza a sí mismo</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>un agujero tocaría el borde u otro agujero</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>quedarían muy pocos puntos para encerrar algo</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>las ranuras no dejan nada de ninguna sección, así que no hay nada que cortar</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>todavía no hay ninguna sección, así que no hay nada que cortar</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>no se puede cubrir ninguno de los huecos entre sus contornos (%1), así que no hay piel</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>no hay contornos que se crucen en sus bordes, así que no hay piel</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>no existe el comando «%1»</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>ese comando no existe</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>este evento no tiene sentido aquí</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>esta versión no admite «%1»</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>esta versión no lo admite</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>esto no se pudo calcular</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>«%1» no se pudo cortar: no se pudo calcular qué dejan de ella sus ranuras</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>una sección no se pudo cortar</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>no se pudo calcular el sólido de «%1»</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>no se pudo calcular un sólido</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>las marcas de «%1» no se pudieron recortar en su borde</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>las marcas de una sección no se pudieron recortar en su borde</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>no se pudieron calcular las secciones de la operación «%1»</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>no se pudieron calcular las secciones de una operación</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>algo falló dentro de FlatFitFab (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>algo falló dentro de FlatFitFab</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>se detuvo</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>el contenido de este archivo está dañado</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 estaba algo torcida y se ha enderezado</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>una sección estaba algo torcida y se ha enderezado</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>el contorno de %1 se cruza a sí mismo; se conservó su lazo más grande</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>un contorno se cruza a sí mismo; se conservó su lazo más grande</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>un agujero de %1 se sale de su contorno y se omitió</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>un agujero se sale de su contorno y se omitió</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>un agujero de %1 no tiene superficie y se omitió</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>un agujero no tiene superficie y se omitió</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>había agujeros de %1 solapados y se juntaron en uno</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>había agujeros solapados y se juntaron en uno</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>un agujero de %1 se sale de su contorno y se recortó de él</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>un agujero se sale de su contorno y se recortó de él</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>se pasaron por alto las líneas tras la última sección</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>se pasó por alto el texto tras la última sección; líneas: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 no se pudo leer y se omitió</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>se omitió una imagen o una malla</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>se omitió %1: %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>lo que muestra %1 no se pudo leer; se conservó su sitio</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>una plantilla no se pudo leer; se conservó su sitio</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved o scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>tres puntos de control por segmento y uno más</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>al menos una línea</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>dos puntos distintos</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>una palabra de letras y cifras, una sola vez</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>faltan sus datos</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>un SHA-256 de 64 cifras hexadecimales</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>una entrada con este nombre no tiene nada que hacer aquí</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>los datos de esta entrada no coinciden con su nombre, un SHA-256</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>falta esta entrada</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>nada en el documento hace referencia a esta entrada</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point, patch o edge</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point, patch, edge o hanging</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>un ancho de 1 a 10000 mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>una fuerza [x, y, z] mayor que 0, de 1000000 N como máximo</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>una altura de 0 a 10000 mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>una parte de su masa</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden o detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>algo distinto de «made», cada instancia una sola vez</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>un identificador menor que nextId</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>una proporción mayor que 0, 1 como máximo</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>más que el grosor en negativo</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>un ancho y un alto mayores que 0</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone o tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>tres puntos de control por segmento, al menos 6</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom o top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>una dirección de longitud 1</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs o none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>una proporción de 0.05 a 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>algo que se pida a dos secciones, con los pares en orden ascendente</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>una sección madre que no descienda de su hija</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>al menos un material</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>cada pieza una vez, en el orden de las secciones</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>cada sección una vez, en su orden</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none, half, quarter o free</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh, picture o curves</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>nada: solo se atraen mallas</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>un radio de 0.1 a 1000 mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>la ruta de un archivo</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>el SHA-256 de un blob, o un archivo</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>nada: una malla no se apoya en ninguna sección</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>una escala de 1e-9 a 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>una opacidad de 0 a 1</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals o groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>una expresión que no sea tan larga</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice o switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>un nombre sin «=», cada uno una sola vez</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>cada valor una sola vez</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>una palabra de letras y cifras, cada una una sola vez</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>cada número una sola vez</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>una longitud de 1000000 mm como máximo</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>un último punto de control que repita el primero</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>una cantidad</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>un punto de dos números</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>tres puntos de control por segmento y otra vez el primero, al menos 7</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>al menos 1 curva</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>un búfer con bytes</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>un búfer en el archivo</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>una longitud que tenga su búfer</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>un tipo de números que exista en glTF</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>tantos valores como tiene su búfer</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>tantos números como corresponden ahí</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>un nodo que no esté dentro de sí mismo</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>un bloque de un archivo GLB</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>la versión 2 de GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un archivo glTF</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>la versión 2 de glTF</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>un número mayor que 0, 1000000 como máximo</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>un número de 0 a 1000000</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>un número entero dentro de su intervalo</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>un punto [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>un punto [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>una lista de puntos</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>un nombre entre comillas o el final del objeto</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>dos puntos</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>una coma o el final de la lista</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>una secuencia de escape de JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>texto en UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>el final del texto entre comillas</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>otro valor después de la coma</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>no más de 1024 niveles</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>un archivo más pequeño</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>el final del archivo</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>un valor</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>cada clave de un objeto una sola vez</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>las dos mitades de un carácter</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>un color como #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>un ancho de líneas en mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>una velocidad en mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>una línea de G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>líneas de G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>el S más grande</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>ancho y alto en mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>una proporción de 0 a 1</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>un ancho de puentes en mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>una longitud de entradas en mm</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>máquinas</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>una máquina</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triángulos</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>vértices</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>está en otra carpeta</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>una malla</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>al menos tres puntos</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon o polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>al menos un ángulo</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>un problema de distribución en tira</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>al menos un elemento</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>al menos tres esquinas de una cara</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>el número de vértices</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>el número de caras</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>las esquinas de una cara</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>píxeles</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>la imagen está dañada</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>el resto de la imagen</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>la imagen está dañada aquí</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>una imagen PNG, JPEG o WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>una imagen con al menos un píxel</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>nadie está escribiendo en esta tubería</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>no salió nada de ahí en 10 segundos</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>nadie está leyendo de esta tubería</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>el formato</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element o end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii o binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>un tipo como float o int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>antes un elemento</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>tantos valores como dice el archivo</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>la longitud de una lista</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>el disco está lleno</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>el número de triángulos</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>tantos triángulos como dice el archivo</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet o endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex o endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>tres esquinas de un triángulo</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>líneas; el texto debe convertirse antes en trazados</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>líneas; una imagen debe calcarse antes</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>líneas, formas o trazados</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>una transformación</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>grupos dentro de grupos</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>puntos a menos de un kilómetro</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>pares de números</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>datos de trazado</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>elementos y atributos</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>un dibujo SVG</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>una longitud</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>una imagen o un dibujo</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>no hay ningún modelo 3D en este archivo</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>un modelo 3D</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>una unidad como millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>doce números</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>un objeto que no se contenga a sí mismo</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n sección estaba algo torcida y se ha enderezado.</numerusform>
            <numerusform>%n secciones estaban algo torcidas y se han enderezado.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n contorno se cruzaba a sí mismo; se conservó su lazo más grande.</numerusform>
            <numerusform>%n contornos se cruzaban a sí mismos; se conservó el lazo más grande de cada uno.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n agujero se salía de su contorno y se omitió.</numerusform>
            <numerusform>%n agujeros se salían de sus contornos y se omitieron.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n agujero no tenía superficie y se omitió.</numerusform>
            <numerusform>%n agujeros no tenían superficie y se omitieron.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Había agujeros solapados en %n sección y se juntaron.</numerusform>
            <numerusform>Había agujeros solapados en %n secciones y se juntaron.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n agujero se salía de su contorno y se recortó de él.</numerusform>
            <numerusform>%n agujeros se salían de sus contornos y se recortaron de ellos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Se pasó por alto el texto tras la última sección en %n punto.</numerusform>
            <numerusform>Se pasó por alto el texto tras la última sección en %n puntos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>%n imagen o malla no se pudo leer y se omitió.</numerusform>
            <numerusform>%n imágenes o mallas no se pudieron leer y se omitieron.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>%n plantilla no se pudo leer; se conservó su sitio.</numerusform>
            <numerusform>%n plantillas no se pudieron leer; se conservaron sus sitios.</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>la carpeta no se puede usar</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>está abierto en otra ventana</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>puntos donde una línea puede cruzarse a sí misma</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>sus datos están dañados</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>una malla con al menos un triángulo</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>una arista con tres caras o más</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>una malla en la que dos caras se encuentren en una arista</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>lo que debía seguir a «%1» es ahora un número fijo</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n número ya no sigue lo que se había escrito.</numerusform>
            <numerusform>%n números ya no siguen lo que se había escrito.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>una imagen</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>un dibujo</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>cada máquina una vez, en su orden</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>retales</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>un contorno desde 0, 0 que no se cruce</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>grosores</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>lo que puede tener una plancha</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materiales</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>el contorno está abierto: sus extremos distan %1 mm</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>coordenadas de hasta 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>objetos colocados</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diámetro</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Radio de esquina</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Diámetro interior</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Puntas</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Cápsula</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>No se puede hacer</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF, a tamaño real</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, uno por plancha</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF para programas antiguos, R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>Modelos de FlatFitFab</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code para láser GRBL</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code, uno por plancha</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>Mallas glTF</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>Proyecto de LightBurn</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, uno por plancha</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>Mallas OBJ</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, sólidos en su sitio</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, piel como malla</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>Mallas OFF</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Lista de piezas para hojas de cálculo</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, una página por plancha</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, repartido en hojas A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, repartido en hojas Carta</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>Mallas PLY</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Imagen de las planchas</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Imágenes, una por plancha</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>Mallas STL</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, sólidos en su sitio</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, piel como malla</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, sólidos tumbados</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG, a tamaño real</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, uno por plancha</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>Mallas 3MF</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, sólidos en su sitio</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, sólidos tumbados</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Todo para el taller, comprimido</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Todo para el taller, en una carpeta</translation>
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
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; lo deshace.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>No se ha movido nada: donde se cruzan %1 y %2 no hay dos ranuras que compartan la profundidad.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>No ha cambiado nada: %1 y %2 no se pueden unir así.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>No se ha invertido nada: las ranuras de %1 y %2 no se pueden abrir hacia el otro lado.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>No se ha recortado nada: %1 no está dentro de %2, o no quedaría nada de ella.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Mueve para desplazar el corte, suelta para dejarlo ahí. &lt;kbd&gt;Esc&lt;/kbd&gt; lo deja donde estaba.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>No se puede dibujar en un plano visto de canto: gira la vista para seguir.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Trazo descartado: su sección ya no existe.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>No se ha dibujado nada: con esta línea no se puede hacer una sección. Dibújala como un solo lazo abierto.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>No se ha dibujado nada: todo queda por debajo del suelo, donde se corta.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>No se ha hecho ningún agujero: tiene que estar dentro de %1 y dejarla de una pieza.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>El agujero se sale del borde de %1 y se ha recortado de ella.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>El agujero tocaba otros de %1; ahora son uno solo.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>Se han omitido los agujeros de %1 que quedan fuera de su nuevo contorno.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja una sección en el suelo de un solo trazo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja una sección en el plano frontal de un solo trazo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja una sección en el plano lateral de un solo trazo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja una sección paralela a %1 de un solo trazo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Dibuja el nuevo contorno de %1 de un solo trazo. &lt;kbd&gt;Esc&lt;/kbd&gt; conserva el anterior.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja un agujero en %1 de un solo trazo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja un agujero: empieza en la sección que lo recibe. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>No se ha importado nada: ninguna línea de %1 forma un contorno cerrado. Se pueden grabar.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n contorno de %1 no encajaba y se ha omitido.</numerusform>
            <numerusform>%n contornos de %1 no encajaban y se han omitido.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: hubo que omitir %2; %3.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: hubo que omitir %2 y %3; %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n texto</numerusform>
            <numerusform>%n textos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n imagen</numerusform>
            <numerusform>%n imágenes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>se ha leído %n línea</numerusform>
            <numerusform>se han leído %n líneas</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 está inclinada respecto a %1: muévela antes al plano de %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 tiene %n contorno, que es demasiado: cálcala con menos detalle o suavízala antes.</numerusform>
            <numerusform>%1 tiene %n contornos, que son demasiados: cálcala con menos detalle o suavízala antes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>No se ha calcado nada: ninguna parte de %1 está a ese lado del umbral.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: arrastra hacia fuera desde el centro; un clic hace el tamaño habitual.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: arrastra hacia fuera desde el centro para recortarlo de %2.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para dejarlo de este tamaño; &lt;kbd&gt;Mayús&lt;/kbd&gt; iguala los dos lados. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Dibuja la primera sección: pulsa, dibuja su forma de un solo trazo y suelta.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Arrastra para girar la vista; con &lt;kbd&gt;Mayús&lt;/kbd&gt; seleccionas un grupo.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Arrastra hacia fuera de %1 para dibujar una sección que la cruce; haz clic para seleccionarla.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Haz clic para seleccionar %1. Arrastra para girar la vista: no se puede dibujar en una sección vista de canto.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Arrastra para mover el corte por el modelo; &lt;kbd&gt;Esc&lt;/kbd&gt; lo cierra.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Haz clic para seleccionar el problema %1.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Arrastra para mover el punto; &lt;kbd&gt;Ctrl&lt;/kbd&gt; lo hace esquina, las flechas lo mueven 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Arrastra para curvar la línea; &lt;kbd&gt;Ctrl&lt;/kbd&gt; hace una esquina, &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene la dirección.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Haz doble clic para añadir un punto aquí; arrastra para curvar el contorno.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Haz clic para seleccionar la unión entre %1 y %2.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Arrastra para hacer más profunda la ranura de %1 y menos la de %2; haz clic para seleccionar la unión.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Arrastra para hacer más profunda la ranura de %1 y menos la de %2; las flechas mueven 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Arrastra para mover el peso de %1 que hay en %2; haz clic para seleccionarlo.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Las flechas mueven 1&#x202f;mm el peso de %1 que hay en %2; &lt;kbd&gt;+&lt;/kbd&gt; y &lt;kbd&gt;−&lt;/kbd&gt; lo cambian, &lt;kbd&gt;Supr&lt;/kbd&gt; lo quita.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Arrastra para mover el empuje de %1 en %2, o su punta para girarlo; haz clic para seleccionarlo.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Las flechas mueven 1&#x202f;mm el empuje de %1 en %2; &lt;kbd&gt;+&lt;/kbd&gt; y &lt;kbd&gt;−&lt;/kbd&gt; lo cambian, &lt;kbd&gt;Supr&lt;/kbd&gt; lo quita.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 la hace %2: haz clic para editarlas todas y otro clic para esta sola.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Haz clic para seleccionar solo %1; arrastra hacia fuera de ella para dibujar una sección que la cruce.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Arrastra un tirador redondo para mover el principio o el final de %1; haz clic en una sección para seleccionarla.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Arrastra para mover el principio de %1; haz clic para escribirlo.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Arrastra para mover el final de %1; haz clic para escribirlo.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Haz clic para mirar de frente; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Haz clic para mirar desde detrás; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Haz clic para mirar desde la izquierda; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Haz clic para mirar desde la derecha; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Haz clic para mirar desde arriba; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Haz clic para mirar desde abajo; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Haz clic para mirar esta arista; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Haz clic para mirar esta esquina; arrastra para girar la vista.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Arrastra para girar la vista; la rueda acerca y aleja.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para dejarlo aquí: la ranura de %1 ocupa el %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Haz clic en un punto de una sección para poner ahí %1. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Pulsa en una sección y arrastra en la dirección del empuje. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Pulsa en una sección y arrastra para tirar de ella y ver qué pasa; no se guarda nada.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Suelta y vuelve a su sitio: no se guarda nada.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Arrastra para moverlo. Un &lt;b&gt;clic&lt;/b&gt; lo selecciona.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>Arrastra la punta para girar el empuje; una flecha más larga empuja más fuerte.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Suelta para poner aquí el peso. &lt;kbd&gt;Esc&lt;/kbd&gt; lo deja donde estaba.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Suelta para empujar aquí. &lt;kbd&gt;Esc&lt;/kbd&gt; lo deja donde estaba.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>No se ha añadido ningún peso: haz clic en una sección.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>No se ha añadido ningún empuje: pulsa en una sección.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>La copia de %1 también lo lleva; en &lt;i&gt;Propiedades&lt;/i&gt; puedes dejarlo solo en esta.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>%n copia de %1 también lo lleva; en &lt;i&gt;Propiedades&lt;/i&gt; puedes dejarlo solo en esta.</numerusform>
            <numerusform>%n copias de %1 también lo llevan; en &lt;i&gt;Propiedades&lt;/i&gt; puedes dejarlo solo en esta.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>El peso se queda donde está: ahí se saldría de %1.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>El empuje se queda donde está: ahí se saldría de %1.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Arrastra para indicar hasta dónde atrae %1 las plantillas.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Suelta para que %1 atraiga las plantillas desde %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja en la sección que quieres grabar o haz clic en ella. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Arrastra para dibujar una línea en %1; &lt;kbd&gt;Mayús&lt;/kbd&gt; la mantiene recta. Haz clic para poner texto.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para conservar la línea. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 se graba por delante, la única cara a la que llega el láser; la vista se ha girado hacia ella.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>No se ha grabado nada: eso no está en %1.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>El carácter «%1» no se puede grabar.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Arrastra de un punto a otro para medir; con &lt;kbd&gt;Ctrl&lt;/kbd&gt; no se ajusta. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ve al segundo punto. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Haz clic o arrastra para medir otra vez. &lt;kbd&gt;Esc&lt;/kbd&gt; lo borra.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Arrastra a lo largo de algo cuya longitud conozcas; le sigue el modelo entero. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Escribe la longitud que quieres; &lt;kbd&gt;Intro&lt;/kbd&gt; escala el modelo entero. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>El modelo no puede ser tan grande o tan pequeño.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>El modelo no se puede escalar tanto: %1 se saldría de sus límites.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Haz clic en la sección que hará de espejo; arrastra para girar la vista. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: hacer un círculo</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: hacer una elipse</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: poner rectas sus líneas</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: esquinas en ángulo recto</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: apartar su ranura del borde</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>Ahora es un círculo.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>Ahora es una elipse.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Líneas enderezadas.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Esquinas en ángulo recto.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Apartada del borde.</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 se queda donde se dibujó: apartada del borde, su ranura partiría %2. Dibuja cruzando el borde, no a lo largo de él.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Suelta para que %1 empiece aquí: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Suelta para que %1 termine aquí: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Arrastra hacia fuera de una sección para cruzarla con la pluma; arrastra aquí para girar la vista. &lt;kbd&gt;Esc&lt;/kbd&gt; deja la pluma.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Arrastra hacia fuera de %1 para cruzarla con la pluma; haz clic para seleccionarla.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Haz clic para poner el primer punto, arrastra para curvar. &lt;kbd&gt;Esc&lt;/kbd&gt; deja la pluma.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Haz clic para poner un punto, arrastra para curvar; &lt;kbd&gt;Intro&lt;/kbd&gt; cierra, &lt;kbd&gt;Retroceso&lt;/kbd&gt; quita uno.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Haz clic para poner un punto, arrastra para curvar; &lt;kbd&gt;Intro&lt;/kbd&gt; cierra, &lt;kbd&gt;Retroceso&lt;/kbd&gt; quita uno. Con &lt;kbd&gt;Ctrl&lt;/kbd&gt;, el clic no se ajusta.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>El contorno se cruza a sí mismo: &lt;kbd&gt;Intro&lt;/kbd&gt; conserva el lazo más grande, &lt;kbd&gt;Retroceso&lt;/kbd&gt; quita un punto.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Arrastra para curvar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; hace una esquina, &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene la dirección.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Arrastra para mover el punto; con &lt;kbd&gt;Ctrl&lt;/kbd&gt; no se ajusta, &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene la dirección.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Arrastra el tirador para curvar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; hace una esquina.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Haz clic para cerrar el contorno; arrastra para mover el punto.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Intro&lt;/kbd&gt; pone el punto, &lt;kbd&gt;Tab&lt;/kbd&gt; pasa al número siguiente. &lt;kbd&gt;Esc&lt;/kbd&gt; cierra la barra.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Sin cerrar: los puntos aún no encierran nada.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Queda un contorno abierto: &lt;kbd&gt;Intro&lt;/kbd&gt; lo cierra, &lt;kbd&gt;Esc&lt;/kbd&gt; lo quita.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 De momento: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 De momento: %2. &lt;kbd&gt;Intro&lt;/kbd&gt; lo hace.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Intro&lt;/kbd&gt; lo hace. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Suelta para dejarlo aquí. &lt;kbd&gt;Ctrl&lt;/kbd&gt; hace una esquina, &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene la dirección.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Suelta para dejarlo así. &lt;kbd&gt;Ctrl&lt;/kbd&gt; hace una esquina, &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene la dirección.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para dejarlo así. &lt;kbd&gt;Ctrl&lt;/kbd&gt; hace esquinas en sus extremos. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>El contorno se cruzaría aquí a sí mismo; se queda como estaba justo antes.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Un agujero tocaría aquí el borde u otro agujero; se queda como estaba justo antes.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>Aquí el suelo cortaría %1 por completo; se queda como estaba.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>No se ha eliminado nada: un contorno necesita al menos dos puntos.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para seleccionar todo lo que está completamente dentro. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para seleccionar los puntos de dentro. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 conserva su ángulo con %2. Libérala para girarla como quieras.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 no está en otra sección, así que no forma ángulo con ninguna.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 no puede estar en %2, que está en ella.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 y %2 no se cruzan: mueve antes una de ellas hasta que atraviese la otra.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Haz clic en la sección en la que quieres poner %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Arrastra para girar la vista; &lt;kbd&gt;Espacio&lt;/kbd&gt; reproduce, &lt;kbd&gt;←&lt;/kbd&gt; y &lt;kbd&gt;→&lt;/kbd&gt; van paso a paso. &lt;kbd&gt;Esc&lt;/kbd&gt; cierra los pasos.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>El modelo ha cambiado, por eso se ha cerrado la vista de sus pasos.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Sigue arrastrando hasta salir de %1; la ranura termina en su borde. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Sigue arrastrando hasta salir de %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; deja la ranura como la dibujas. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>La vista está girando: sigue dibujando ya o espera a que se pare.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Dibuja el contorno: sal de la zona gris por donde deba empezar. Suelta aquí para cancelar.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Dibuja el contorno y suelta para cerrarlo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para hacer la sección. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para cortar el agujero en %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para dar a %1 este contorno. &lt;kbd&gt;Esc&lt;/kbd&gt; conserva el anterior.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para hacer la sección, reflejada respecto a la ranura. Mantén &lt;kbd&gt;Mayús&lt;/kbd&gt; para quedarte solo con este lado. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para hacer la sección, reflejada. Deja de pulsar &lt;kbd&gt;Mayús&lt;/kbd&gt; para quedarte solo con este lado. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para dar a %1 este contorno, reflejado respecto a su ranura. &lt;kbd&gt;Mayús&lt;/kbd&gt; hace lo contrario.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Suelta&lt;/b&gt; para hacer la sección, reflejada respecto a la vertical. Mantén &lt;kbd&gt;Mayús&lt;/kbd&gt; para quedarte solo con este lado.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sigue la curva verde azulada para ajustarte a %1; mantén &lt;kbd&gt;Ctrl&lt;/kbd&gt; para apartarte. &lt;kbd&gt;Mayús+Intro&lt;/kbd&gt; la toma entera.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Mayús+Intro: tomar la guía entera</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>La ranura no toca ninguna guía, así que no hay ninguna que tomar entera.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>No se ha dibujado nada: la ranura no llegó a salir de %1. Empieza dentro y arrastra cruzando su borde; &lt;kbd&gt;O&lt;/kbd&gt; dibuja agujeros, &lt;kbd&gt;E&lt;/kbd&gt; graba.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>No se ha dibujado nada: la línea es demasiado corta para encerrar algo.</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>No se ha dibujado nada: una línea de menos de %1 se toma por un descuido de la mano, salvo que cierre un lazo.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>No se ha dibujado nada: la línea va y vuelve y no encierra nada.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>No se ha dibujado nada: la línea se cruza a sí misma y ninguno de sus lazos es bastante grande.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 no se ha reflejado: las dos mitades no se tocarían.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>El contorno se cruza a sí mismo; se ha conservado el lazo más grande.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 se ha reflejado; se ha omitido lo que cruzaba su eje y volvía.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 no llega a su ranura: nada la une a %2.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 se ha dibujado al lado de su ranura: ha recibido un cuello y se ha cortado a ras de suelo.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 se ha dibujado al lado de su ranura y ha recibido un cuello que llega hasta ella.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 no es simétrica: sus mitades son distintas.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Arrastra una flecha para mover %1, un anillo para girarla, un cuadro para escalarla; o escribe números. &lt;kbd&gt;Esc&lt;/kbd&gt; oculta los tiradores.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Arrastra para mover; &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene una sola dirección.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Arrastra para girar.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Arrastra para escalar.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para dejarlo así. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 está bloqueada.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 no se puede mover o escalar tanto.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Arrastra a lo largo de algo de %1 cuya longitud conozcas; &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene ocho direcciones. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Escribe cuánto mide; &lt;kbd&gt;Intro&lt;/kbd&gt; da ese tamaño a %1. &lt;kbd&gt;Esc&lt;/kbd&gt; borra la línea.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ningún trozo plano de %1 es bastante grande para una sección: agrándala antes.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Tiene más de %1 trozos planos: elige menos caras.</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Una plancha de %1 no se pliega: elige un material de %2 o menos.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Pliega por las líneas rayadas y une después los bordes con el mismo número: %n costura.</numerusform>
            <numerusform>Pliega por las líneas rayadas y une después los bordes con el mismo número: %n costuras.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Haz clic en la sección que quieres mover o girar, o arrástrala. &lt;kbd&gt;Esc&lt;/kbd&gt; oculta los tiradores.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Arrastra una flecha para mover, un anillo para girar, un cuadro para escalar; o escribe números. &lt;kbd&gt;Esc&lt;/kbd&gt; oculta los tiradores.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Arrastra para mover %1; haz clic para seleccionarla.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Arrastra para mover; &lt;kbd&gt;Ctrl&lt;/kbd&gt; deja una copia, &lt;kbd&gt;Mayús&lt;/kbd&gt; mantiene una sola dirección.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Arrastra para girar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; deja una copia.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Arrastra para escalar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; deja una copia.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para dejarlo así. &lt;kbd&gt;Ctrl&lt;/kbd&gt; deja una copia, &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Suelta para dejar aquí una copia. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Intro&lt;/kbd&gt; lo deja así. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Intro&lt;/kbd&gt; hace %n copia así. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</numerusform>
            <numerusform>&lt;kbd&gt;Intro&lt;/kbd&gt; hace %n copias así, cada una un paso más allá. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Un preajuste necesita un nombre, sin «=» y sin espacios al principio ni al final.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Los demás todavía no pueden adaptar ningún valor, así que no hay nada que conservar.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>No hay ningún preajuste llamado «%1».</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>Esto es lo que verán los demás. Guarda el archivo y pásaselo; se abre así.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n que salía de él es ahora un simple número.</numerusform>
            <numerusform>%n que salían de él son ahora simples números.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>Con él se ha ido %n preajuste que no establecía nada más.</numerusform>
            <numerusform>Con él se han ido %n preajustes que no establecían nada más.</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>No se han encontrado intervalos más estrechos en los que el modelo aguante.</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Mueve para girar la vista, suelta para parar.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Mueve para desplazar la vista, suelta para parar.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Mueve hacia arriba para acercar, hacia abajo para alejar; suelta para parar.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>No ha cambiado nada: aquí no se puede hacer.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 está bloqueada. Desbloquéala en el Esquema para cambiarla.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 la hace %2: edita su origen o separa esta.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>No quedaría nada de %1; se queda como estaba.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 se ha cortado a ras de suelo.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1 se ha partido al cortarla a ras de suelo; se ha conservado el trozo más grande.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>No se ha pegado nada: lo que se copió no contiene secciones ni ninguna imagen.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>No se ha copiado nada: el modelo ya es simétrico.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>No se ha eliminado nada: una unión está donde se cruzan dos secciones. Elimina una de ellas o elige el tipo «Ninguna».</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>«%1» es ahora lo que está puesto, en lugar de lo que era.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Dibuja primero una sección: todavía no hay nada que reflejar.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Dibuja primero una sección: todavía no hay nada que repetir ni dividir.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n borde no tiene dientes: sus planchas se encuentran con un ángulo demasiado abierto o cerrado, o es demasiado corto. Ayudan menos caras, o rebanadas en su lugar.</numerusform>
            <numerusform>%n bordes no tienen dientes: sus planchas se encuentran con un ángulo demasiado abierto o cerrado, o son demasiado cortos. Ayudan menos caras, o rebanadas en su lugar.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Añade una imagen reflejada de lo seleccionado. &lt;kbd&gt;Intro&lt;/kbd&gt; refleja; &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Lo que cambias en un lado cambia también en el otro. &lt;kbd&gt;Intro&lt;/kbd&gt; refleja; &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Iguala los dos lados una vez; después cada uno va por su cuenta. &lt;kbd&gt;Intro&lt;/kbd&gt; refleja; &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
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
        <translation>Vaso de agua</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Tenedor</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Cuchillo</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Cuchara</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Libro</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Maceta</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Se omitió una cara: le falta una esquina.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>Se omitió %n cara: le falta una esquina.</numerusform>
            <numerusform>Se omitieron %n caras: les falta una esquina.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Se omitió una cara: la posición de una esquina no es un número.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>Se omitió %n cara: la posición de una esquina no es un número.</numerusform>
            <numerusform>Se omitieron %n caras: la posición de una esquina no es un número.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Se omitió una cara: tiene una esquina repetida.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>Se omitió %n cara: tiene una esquina repetida.</numerusform>
            <numerusform>Se omitieron %n caras: tienen una esquina repetida.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Se omitió una cara: está dos veces.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>Se omitió %n cara: está dos veces.</numerusform>
            <numerusform>Se omitieron %n caras: están dos veces.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Una cara miraba hacia el lado equivocado y se le dio la vuelta.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n cara miraba hacia el lado equivocado y se le dio la vuelta.</numerusform>
            <numerusform>%n caras miraban hacia el lado equivocado y se les dio la vuelta.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>La superficie tiene un agujero: una arista está abierta.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>La superficie tiene agujeros: %n arista está abierta.</numerusform>
            <numerusform>La superficie tiene agujeros: %n aristas están abiertas.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>En una arista se encuentran más de dos caras.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>En %n arista se encuentran más de dos caras.</numerusform>
            <numerusform>En %n aristas se encuentran más de dos caras.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>En una arista se encuentran caras que no pueden mirar hacia el mismo lado.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>En %n arista se encuentran caras que no pueden mirar hacia el mismo lado.</numerusform>
            <numerusform>En %n aristas se encuentran caras que no pueden mirar hacia el mismo lado.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>Estaba del revés y se le dio la vuelta.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Un hueco en el corte se cerró con una curva suave.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n hueco en el corte se cerró con una curva suave.</numerusform>
            <numerusform>%n huecos en el corte se cerraron con curvas suaves.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>Plano</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>Cómo</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 no dice qué tamaño tiene en mm o pulgadas; el retal se toma como de %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: el contorno se cruza a sí mismo; se toma su trozo más grande, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: hay líneas que cortan el retal en trozos; se toma el más grande, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: hay líneas abiertas en el retal; lo que encerrarían si estuvieran cerradas queda libre.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Contando las secciones que ya están</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>Paso X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Paso Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Paso Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Repite secciones a lo largo de una línea en el espacio.</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>Serie de %1</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secciones</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Haz clic en las secciones que quieres repetir.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transición</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Interpola entre secciones.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>Transición de %1</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Haz clic, en orden, en las secciones de la transición.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>A lo largo de</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Haz clic en la sección a lo largo de la cual debe ir.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Cantidad por hueco</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Colocación</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Ritmo</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>Extremos lentos</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Emparejar</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Como está dibujado</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Al revés</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crecimiento</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Tamaño de una copia</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Variar tamaño ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Variar ángulo ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Tamaño mínimo</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Como máximo</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramas</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Hace crecer copias de una sección, con todo lo que lleva, en lugar de sus hijas, una y otra vez.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>Ramas de %1</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Raíz</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Haz clic en la sección que se ramifica.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Sujeta por</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Haz clic en la sección que la sujeta: las copias se sujetan igual.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Hijas</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Haz clic en las secciones hijas que las copias deben sustituir.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Divide una sección demasiado grande en celdas que se mantienen unidas.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>Cuadrícula de %1</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Haz clic en la sección que quieres dividir.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Caber en mi plancha</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Celdas</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Ancho de celda</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Alto de celda</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Borde</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Recto con conectores</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Puzle</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bordes</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Conectores por borde</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Tamaño de conector</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Holgura</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Unir restos menores de</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambos</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Igual profundidad dentro</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>De cada copia queda la misma longitud dentro de la otra sección</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Fila</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Repite una sección en fila a lo largo de otra.</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>Fila de %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Engranaje</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Agujeros</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Sector dibujado</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Sectores</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Radio exterior</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Radio interior</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Diente</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redondo</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Cuadrado</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapecio</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>Aplicar a</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>Círculo de %1</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>Estrella de %1</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>Agujeros de %1</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>Roseta de %1</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>Engranaje de %1</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Convierte una sección en un círculo, una estrella o un engranaje, o corta en ella agujeros así.</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Haz clic en la sección a la que quieres dar forma.</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Haz clic en la sección que quieres repetir.</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Rama entera</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Con todo lo que cuelga de ella</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Repetir por</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>No</source>
        <translation>No</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Según el grosor local</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Sección entera</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>A lo largo de la ranura</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>No menos de</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Fuera</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Dentro</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Ángulo con el borde</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>Toda la vuelta</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Abanico</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Repite una sección alrededor del contorno de otra.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>Abanico de %1</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Planos</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>a través de X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>a través de Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>a través de Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>a través de X e Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>a través de X y Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>a través de Y y Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>a lo largo de una curva</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Rebanadas</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Por</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>En cada dirección</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>De todos los planos, como parte de su separación</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Trozo más pequeño</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>En mm²; se omiten los más pequeños y los que son finos por todas partes</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Huecas</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Solo queda una pared a lo largo del contorno</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Corta una malla en secciones que siguen su forma.</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Haz clic en la sección cuyo contorno debe seguir.</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Haz clic en las secciones a las que se aplica.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Se aplica a</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Todo el modelo</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Espejo</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Repite en un lado todo lo dibujado en el otro.</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Haz clic en la sección que hará de espejo.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>El plano de una sección</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>Unir en el plano</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Repite alrededor de un eje todo lo dibujado una vez.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Haz clic en las dos secciones cuya ranura es el eje.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Ranura</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>como una sección</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>alrededor de Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>alrededor de X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>alrededor de Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Como</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Haz clic en la sección a la que deben ser paralelas.</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>on</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>off</source>
        <translation>no</translation>
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
        <translation>%1 aún no hace nada: falta elegir «%2».</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 ha perdido su sección «%2», que se eliminó. No hace nada hasta que elijas otra.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 no hace nada: sus secciones no se cruzan.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 no hace nada: no hay sitio dentro de su intervalo.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 no tiene nada que dividir: la sección cabe en una sola celda.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 no se pudo calcular: faltan sus secciones.</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 se paró en 1 sección.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 se paró en %n sección.</numerusform>
            <numerusform>%1 se paró en %n secciones.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Se omitió 1 sección de %1, pues no hay nada que la sujete.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>Se omitió %n sección de %1, pues no hay nada que la sujete.</numerusform>
            <numerusform>Se omitieron %n secciones de %1, pues no hay nada que las sujete.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 no hace nada: su plantilla ya no está o falta su archivo.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Se omitió 1 trozo pequeño de %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>Se omitió %n trozo pequeño de %1.</numerusform>
            <numerusform>Se omitieron %n trozos pequeños de %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: imprimir al 100 %</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Plancha %1, página %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Desacoplar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
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
        <translation>Mayús</translation>
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
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Ins</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Re Pág</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Av Pág</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abajo</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Detenido: %1. Se vuelve a calcular cuando cambie el modelo.</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>No se pudo calcular: %1. Motivo: %2.</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>lo que se puede hacer con los problemas</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Calculando %1…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>Calculando %1… %2&#x202f;%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>las uniones y ranuras</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>la revisión</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>el orden de montaje</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>si aguanta</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>cuánto aguanta si las secciones se doblan</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>cuánto aguanta cada punto de una sección</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>la piel</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>la distribución de las piezas en las planchas</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>qué hacen los imanes con las plantillas</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>lo que libera las piezas que se estorban</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>Preparar el corte</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>Editar %1</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambiar el material de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Cambiar el material de %n sección</numerusform>
            <numerusform>Cambiar el material de %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Insertar %1</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Bajar al suelo</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ensanchar la base de %1</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Añadir un pie a %1</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Unir %1 y %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>Llevar %1 a %2</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>Llevar %n sección a %1</numerusform>
            <numerusform>Llevar %n secciones a %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Invertir las ranuras de %1</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Mover %1 (%2)</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Hacer montable</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sostener %1 con un pie</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alargar %1 hasta el suelo</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>Alargar %n sección hasta el suelo</numerusform>
            <numerusform>Alargar %n secciones hasta el suelo</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>Dar %2 de grosor a %1</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar %1 a 90°</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ensanchar %1 donde es débil</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: invertir las ranuras</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: punto de encuentro → %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: restablecer lo automático</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → media madera</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → media madera larga</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → mortaja</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → lengüetas</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → ninguna</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Recortar %1 hasta %2</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Redibujar %1</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dibujar un agujero en %1</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dibujar %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Calcar %1</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambiar la forma de %1</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>Poner %1 en %2</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover el peso de %1</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Cambiar el peso a %1</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Renombrar el peso a %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Quitar el peso</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Empujar %1</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover el empuje en %1</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar el empuje en %1</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Cambiar el empuje a %1</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Renombrar el empuje a %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Quitar el empuje</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Repartir la carga en %1</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cargar también las copias de %1</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>No cargar las copias de %1</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Atraer plantillas hacia %1</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Atraer plantillas hacia %n sección</numerusform>
            <numerusform>Atraer plantillas hacia %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Soltar plantillas de %1</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Soltar plantillas de %n sección</numerusform>
            <numerusform>Soltar plantillas de %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Marcar %1</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambiar una marca de %1</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Eliminar una marca de %1</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Escalar el modelo al %1 %</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Hacer de %1 un círculo</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Hacer de %1 una elipse</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Hacer un círculo del agujero de %1</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Hacer una elipse del agujero de %1</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Enderezar las líneas de %1</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Poner en ángulo recto las esquinas de %1</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Apartar %1 del borde</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Añadir un punto a %1</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Eliminar un punto de %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>Eliminar %n punto de %1</numerusform>
            <numerusform>Eliminar %n puntos de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover un tirador de %1</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Curvar el contorno de %1</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover un punto de %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>Mover %n punto de %1</numerusform>
            <numerusform>Mover %n puntos de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambiar un punto de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>Cambiar %n punto de %1</numerusform>
            <numerusform>Cambiar %n puntos de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>Mover %n sección</numerusform>
            <numerusform>Mover %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar %1</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>Girar %n sección</numerusform>
            <numerusform>Girar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Escalar %1</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>Escalar %n sección</numerusform>
            <numerusform>Escalar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Copiar %1</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>Copiar %n sección</numerusform>
            <numerusform>Copiar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Reflejar una copia de %1</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Reflejar una copia de %n sección</numerusform>
            <numerusform>Reflejar copias de %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Poner %1 en ángulo recto</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>Poner %n sección en ángulo recto</numerusform>
            <numerusform>Poner %n secciones en ángulo recto</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alinear %1 con un eje</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>Alinear %n sección con un eje</numerusform>
            <numerusform>Alinear %n secciones con un eje</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Poner %1 en otra sección</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Liberar %1</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>Liberar %n sección</numerusform>
            <numerusform>Liberar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Vincular %1</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>Vincular %n sección</numerusform>
            <numerusform>Vincular %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Cambiar cómo sigue %1</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Cambiar cómo sigue %n sección</numerusform>
            <numerusform>Cambiar cómo siguen %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Bloquear %1</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>Bloquear %n sección</numerusform>
            <numerusform>Bloquear %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Desbloquear %1</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>Desbloquear %n sección</numerusform>
            <numerusform>Desbloquear %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>Colocar %1 en su plancha</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>Fijar %1</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>Fijar %n pieza</numerusform>
            <numerusform>Fijar %n piezas</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>Soltar %1</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>Soltar %n sección</numerusform>
            <numerusform>Soltar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Soltar todas las piezas</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Cambiar el giro de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Cambiar el giro de %n sección</numerusform>
            <numerusform>Cambiar el giro de %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mantener simétrica %1</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>Mantener simétrica %n sección</numerusform>
            <numerusform>Mantener simétricas %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Dejar distintas las mitades de %1</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Dejar distintas las mitades de %n sección</numerusform>
            <numerusform>Dejar distintas las mitades de %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Añadir la plantilla %1</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Quitar la plantilla %1</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Cambiar la plantilla %1</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Mover la plantilla %1</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Girar la plantilla %1</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Escalar la plantilla %1</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>Alinear %1 y %2</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ocultar la plantilla %1</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Mostrar la plantilla %1</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Sugerir %n sección para %1</numerusform>
            <numerusform>Sugerir %n secciones para %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Hacer facetas de %1</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Desplegar %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>Establecer %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>Renombrar %1 a %2</translation>
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
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Conservar el preajuste %1</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Poner en %1</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Eliminar el preajuste %1</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Compartir para adaptar</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Editar el diseño</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Establecer los valores</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Estrechar los intervalos</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>Renombrar %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Eliminar %n sección</numerusform>
            <numerusform>Eliminar %n secciones</numerusform>
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
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Cambiar el orden de %1</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Omitir %1</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>Omitir %n sección</numerusform>
            <numerusform>Omitir %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Recuperar una sección omitida</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cortar %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>Cortar %n sección</numerusform>
            <numerusform>Cortar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Pegar %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>Pegar %n sección</numerusform>
            <numerusform>Pegar %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Conservar la cota</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Eliminar la cota</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Hacer simétrico</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Activar %1</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Desactivar %1</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Convertir %1</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Separar %1</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Quitar los agujeros de %1</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Quitar los agujeros de %n sección</numerusform>
            <numerusform>Quitar los agujeros de %n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Desplazar planos de %1</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Cambiar el número de planos de %1</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Cambiar la separación de los planos de %1</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 es demasiado pequeña o demasiado fina para secciones de %2 de grosor.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>No se han encontrado secciones de %1 que se sujeten entre sí y se tengan en pie.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>No se ha encontrado otra sección de %1 que encaje entre las que hay.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Solo se ha encontrado %n sección de %1: cualquier otra le estorbaría o no tendría nada que la sujete.</numerusform>
            <numerusform>Solo se han encontrado %n secciones de %1: cualquier otra les estorbaría o no tendría nada que la sujete.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n sección de %1 es lo mínimo que se ha encontrado que se tenga en pie.</numerusform>
            <numerusform>%n secciones de %1 son lo mínimo que se ha encontrado que se tenga en pie.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 se ha hundido %2 en el suelo, para que sus secciones se apoyen en un pie plano.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 se ha hundido %2 en el suelo y sus secciones tienen pies de hasta %3 de alto, para que se tengan en pie.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>Es animada; solo se muestra su primera imagen.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>Se omitió %n texto.</numerusform>
            <numerusform>Se omitieron %n textos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>Se omitió %n imagen.</numerusform>
            <numerusform>Se omitieron %n imágenes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Falta un número, un nombre o un cálculo.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Una expresión no tiene más de %1 letras; esta es más larga.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>En «%1», la expresión tiene más de %2 números, nombres y signos.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>En «%1» hay más de %2 paréntesis o signos unos dentro de otros.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>«%1» no se puede leer aquí.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Falta algo después de «%1».</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Falta algo antes de «%1».</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Entre «%1» y «%2» falta un signo, como + o *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>El paréntesis de «%1» no está cerrado.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Después de «%1» sobra un paréntesis de cierre.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>Al texto de «%1» le faltan las comillas de cierre.</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>«%1» puede ser un número o dos: escribe un punto, o un espacio tras la coma.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>«%1» es una unidad; delante debe ir un número.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>«%1» se puede entender de dos maneras: pon «%2» entre paréntesis.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>«%1» es una segunda comparación; and(…; …) junta dos.</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>No hay ninguna función llamada «%1».</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>«%1» lleva %2 entre sus paréntesis, no %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>«%1» lleva al menos %2 entre sus paréntesis, no %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>«%1» lleva como máximo %2 entre sus paréntesis, no %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>No hay ningún valor llamado «%1».</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>«%1» es el grosor del material; aquí no hay un único material.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>«%1» es %2, así que no puede tener una unidad propia.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>«%1» es %2 y «%3» es %4; solo se puede sumar o comparar lo que es de la misma clase.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>«%1» es %2; con eso no se puede calcular.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>«%1» es %2; lo que se necesita aquí es %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>«%1» es %2; solo se puede elevar a un número entero pequeño, como 2, no a «%3».</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>«%1» multiplica demasiadas longitudes, ángulos o masas.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>«%1» es %2, que no tiene raíz cuadrada.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>«%1» es 0, y no se puede dividir entre 0.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>«%1» es negativo y no tiene raíz cuadrada.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>La tangente de «%1» es infinita.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>«%1» no está entre −1 y 1, así que no corresponde a ningún ángulo.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>«%1» no es mayor que 0, y no se puede redondear a pasos así.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>«%1» es demasiado grande.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>«%1» es %2, que no es un número entero; round, floor o ceil lo hacen entero.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>«%1» es %2; tiene que ser al menos %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>«%1» es %2; puede ser como máximo %3.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>«%1» es «%2», que no está entre las opciones.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>«%1» da un texto de más de %2 letras.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Este valor depende de sí mismo: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Este valor depende de «%1», que ahora mismo no tiene ninguno.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Hay dos valores llamados «%1».</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>«%1» no es un nombre; un nombre es una letra y después letras, cifras y _, %2 como máximo.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>«%1» no puede ser un nombre, porque significa algo en las expresiones.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Este valor ya no existe.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>La llave de «%1» no está cerrada.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>un simple número</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>una longitud</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>una superficie</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volumen</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un ángulo</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>una masa</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>un sí o no</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>ni longitud ni ángulo ni masa ni simple número</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Sección %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Secciones %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 y %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>No hay ningún material «%1». Elige uno del archivo o de la lista de materiales, como Birch plywood, Acrylic o Card.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 no deja sitio para ranuras en el material %2: su holgura es de %3 mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 no es compatible con el material %2, que tiene %3 mm de grosor.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>un archivo %1</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>un archivo %1 de %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1; o %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>Uso: %1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Muestra esta ayuda.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>No se ha indicado ningún archivo.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Demasiados archivos: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Da otro número a un valor con nombre del modelo, o todo lo que establece un preajuste; se puede repetir.</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Grosor de todos los materiales.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Corta todas las secciones de este material, o del de un archivo .fff.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Ancho total que quita la máquina.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Holgura que se añade a las ranuras; menos de 0 para encajar a presión.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Dice, de cada cosa del archivo que se corrigió, dónde está.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: se encontró «%2», se esperaba %3.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: se encontró «%2», se esperaba un número de %3 a %4.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: se encontró «%1», se esperaba ancho x alto en mm, como 600x400.</translation>
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
        <translation>Junta los %1 listones: lo que le falta a su ancho para %2 mm, dividido entre %1, es el ancho de corte.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Puentes que sujetan cada pieza en su plancha, y su ancho en mm, como 3:0.4 (ninguno).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Empieza y termina cada corte a esta distancia de su línea, en el sobrante (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Corta una sola vez los bordes de dos piezas que coinciden; con --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Escribe una pieza de prueba en lugar de las piezas: ranuras de anchos numerados y listones que indican el ancho de corte.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: se encontró «%1», se esperaba un número de 0 a %2, después dos puntos y un ancho de %3 a %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: se encontró «%2», se esperaba un número de 0 a %3.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Paso %1: empieza con la pieza %2</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Paso %1: empieza un grupo aparte con la pieza %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Paso %1: pieza %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Paso %1: las piezas %2 juntas, que unen lo montado en los pasos %3 y %4</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Secciones: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Uniones: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 y %2 se cruzan, pero ninguna ranura les permite encajar.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Todas las secciones se mantienen unidas.</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>una pieza de %1</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Sin unir al resto: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Tamaño: %1 × %2 × %3 mm (ancho, alto, fondo)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Masa: %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Material: %1, %2 mm, planchas de %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Pieza %1: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, uniones %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>No hay nada que cortar: el modelo no tiene secciones.</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>No hay nada que cortar: las ranuras no dejan nada de ninguna sección.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>Falta -o: indica el archivo que se escribe.</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: un archivo necesita un nombre.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: este tipo de archivo no se puede escribir; se esperaba %2.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Pone junto al modelo una malla, una imagen o un dibujo (SVG), con esta dimensión máxima en mm; se puede indicar varias veces.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: se encontró «%1», se esperaba un archivo, o un archivo y su tamaño en mm, como ball.stl@80.</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>El archivo .fff que se escribe; - es la salida estándar.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Escala la malla a esta dimensión máxima; sin ella, lo grande que diga su archivo, y si no, 254.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: se encontró «%2», se esperaba un número entero de %3 a %4.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: este elemento no cabe en la tira.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Longitud: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Densidad: %1 %</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Piezas: %1, planchas: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm, %3: %4 piezas, %5 % ocupado</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: una pieza no cabe en su plancha.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: se encontró «%1», se esperaba groups o files.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: no hay ninguna máquina «%1»; se esperaba %2 o un archivo .json.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files necesita un nombre: la salida estándar es un solo archivo.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>Las ranuras se dibujan de %1 mm de ancho.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>Las ranuras se dibujan de %1 mm de ancho (%2 − %3 de ancho de corte).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Siguen ahí planchas de una exportación anterior: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Parches: %1, triángulos: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Huecos que quedan abiertos: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: %2 m de corte, unos %3 min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>Las planchas son más grandes que su mesa de %1 x %2 mm; elige otras con --sheet.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Piezas: %1, planchas: %2, %3 % aprovechado.</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>El archivo que se escribe; - es la salida estándar.</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1; necesario si el nombre del archivo no lo dice.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Omite la barra de 100 mm junto a las planchas.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Del borde de la plancha al corte más cercano (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Entre cortes vecinos (2).</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Solo cuartos de vuelta, para planchas con veta.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Coloca las piezas por su contorno real, buscando tantos segundos; 0 toma la primera distribución (por sus rectángulos).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: un SVG con un grupo por plancha; files: OUT-1.svg, OUT-2.svg, etc. (groups).</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>La máquina que corta, por sus colores, velocidades y G-code: %1; o un archivo .json con una propia (generic).</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Escribe la forma que sugieren las secciones, como superficie (%1), en lugar de los sólidos.</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Con -o - falta el formato: --format %1.</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: este tipo de archivo no puede contenerla; se esperaba %1.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: este tipo de archivo no puede contenerla; se esperaba %1.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Píxeles de la imagen (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>De iso1 a iso4, front, right, top, left, back, bottom, o fit: otra vez de frente (iso1).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: se encontró «%1», se esperaba ancho x alto en píxeles hasta %2, como 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: se encontró «%1», se esperaba uno de estos: %2.</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Se tiene en pie.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Se cae.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Se cae: solo se apoya en una línea.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Una parte no tiene dónde apoyarse.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>No está en el suelo.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Resbala por el suelo.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>Sus piezas se mueven unas respecto a otras.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Aguanta.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Aguanta por poco: puede agrietarse en una esquina.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Se rompe.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Se abre una unión.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>La resistencia solo se calcula para lo que está quieto.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Sin valorar: no se conoce la resistencia de un material.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>No se pudo calcular si aguanta.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Se tendría en pie %1.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Demasiado débil: aguanta, pero no con la seguridad que se pide.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Aguantaría %1.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 se apoya en el suelo con %2 N.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>La unión %1–%2 se abre con %3 N: pégala o invierte sus ranuras.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>No se pudo calcular cómo se dobla %1; se considera rígida.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>No se pudo calcular cómo se doblan las secciones; se consideran rígidas.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Las uniones pueden repartirse la carga de más de una manera (indeterminado, %1); cuenta la peor.</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>No se pudo calcular la tensión en %1.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 está sin valorar: no se conoce la resistencia de su material.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Un empuje de %1 N cae fuera del material de %2; lo soporta el punto más cercano.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Un peso de %1 cae fuera del material de %2; lo soporta el punto más cercano.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 en total</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1 N en total</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 veces la carga</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>Lo más débil está en %1: %2 de la resistencia de su material en la parte más estrecha, %3 en la esquina.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Se dobla %1 mm, sobre todo %2.</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Puede agrietarse a partir de %1.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Se rompe con %1.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Pesa %1 N con todo lo que lleva.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>se encontró «%1», se esperaba NOMBRE=VALOR, como width=400.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>se encontró «%1», se esperaba NOMBRE=VALOR, como width=400, o un preajuste: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>«%1» puede ser %2 o %3; escribe uno de ellos.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>el modelo no tiene valores con nombre.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>no hay ningún valor «%1»; se esperaba %2.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Ningún valor que los demás puedan adaptar tiene intervalo y se usa.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Probado: %1 de %2 extremos de los intervalos, %3 variantes entre ellos.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Todas son buenas.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 de %2 fallan:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Dónde:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Caras: %1, cuerpos: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>El plano no la corta.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Agujero: %1 mm², %2 puntos</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Contorno: %1 mm², %2 puntos</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Superficie: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Un punto del plano y su normal, seis números separados por comas.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Escala antes la malla a esta dimensión máxima y la apoya en el suelo.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Imprime JSON, para otros programas.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>Falta --plane.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: se encontró «%1», se esperaban seis números, de los que los tres últimos son una dirección.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Sin dientes donde las planchas se encuentran con menos de 30° o más de 150°: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Sin dientes donde una plancha rebasa a la otra o no llega a ella: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Sin dientes en bordes demasiado cortos para tres de ellos: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Una plancha de %1 mm no se pliega, se esperaba de %2 mm como máximo; --stock elige otra.</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: tiene %2 trozos planos, se esperaban como máximo %3; --faces los reduce.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: ningún trozo plano es bastante grande para una sección; --size la agranda.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Desarrollos: %1, pliegues: %2, costuras: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Simplifica antes la malla a este número de triángulos; los que están juntos en un plano forman un trozo.</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Desarrollos para plegar por líneas rayadas, de plancha de hasta 3 mm, en lugar de planchas planas.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Con --unfold: ancho de las pestañas para pegar; 8 mm en planchas de hasta 1,5 mm; si no, 0 mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap es de --unfold.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Trozos demasiado pequeños para una sección: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Secciones: %1, uniones: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Cuánto tiempo se busca (10); 0 toma la primera distribución.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Otro número da otra distribución, el mismo da la misma.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Cómo se pueden girar las piezas: none (nada), 180, 90 o free (libremente).</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Del borde de la plancha al corte más cercano.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Entre cortes vecinos.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: se encontró «%1», se esperaba none, 180, 90 o free.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>El modelo no tiene operaciones.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 sección</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Imprime JSON, para otros programas; los pasos se cuentan desde 0.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Distancia máxima entre las cuerdas y las curvas (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: este tipo de archivo no se puede escribir; se esperaba .png.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: se encontró «%1», se esperaba labels, checks, stress, forces, skin o varios separados por comas.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: no se muestran fuerzas; no se tiene en pie o no se pudieron calcular. «check» dice por qué.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>El archivo PNG que se escribe; - es la salida estándar.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: los nombres de las secciones; checks: contornea las secciones con problemas; stress: los cortes transversales más débiles; forces: lo que soportan los pies y las uniones; skin: la forma que sugieren las secciones.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Tensión por elementos finitos, en colores por todas las secciones; tarda segundos.</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Una imagen necesita una pantalla con OpenGL 3.3; no hay ninguna.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>La imagen no se pudo escribir como archivo PNG.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>El modelo del que se parte; sin él, uno nuevo.</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: se encontró «%1», se esperaba X, Y, Z, XY, XZ, YZ o radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>Se dieron --count y --spacing a la vez; se esperaba solo uno.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: los planos alrededor de un eje no tienen separación; se esperaba --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>Los ejes que atraviesan los planos: X, Y, Z, dos de ellos para una cuadrícula, o radial: alrededor del eje vertical (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Planos en cada dirección (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>De un plano al siguiente.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: ningún plano corta de ella una sección bastante grande.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size es para .png; un PDF tiene el tamaño de su papel.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper es para .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: se encontró «%1», se esperaba a4 o letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Paso %1 de %2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 o letter (si no se indica, lo habitual en tu país).</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Cuántas secciones (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Otro número da otras secciones (1).</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Preajustes: %1. Está puesto %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Preajustes: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>El modelo no tiene valores con nombre.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Prueba los intervalos de los valores que los demás pueden adaptar.</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Otro número prueba otros puntos, el mismo los mismos.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>hay más celdas que nombres.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Un archivo CSV: nombres de valores y una línea de números por cada variante.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>La carpeta en la que se escribe; se crea si no existe.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>Qué se escribe de cada una (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>Se necesitan tanto --table como -o.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: se encontró «%1», se esperaba un tipo de archivo de corte.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: no se encontró ninguna línea de números, se esperaba una debajo de los nombres.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: unas comillas no están cerradas.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: no se puede crear la carpeta.</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Pone un peso en una sección, en su centro o en X,Y en mm: «Rib 4=350g», «Rib 4@10,25=0.35kg». Se puede repetir.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: se esperaba NOMBRE=MASA, como en «Rib 4=350g».</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: tras el = se esperaba una masa mayor que 0 y de hasta 1000000 kg, con g, kg, oz o lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: no hay ninguna sección «%2».</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: las ranuras no dejan nada de «%2».</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: dos columnas se llaman &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: este tipo de archivo no se puede escribir; se esperaba .pdf, .html o .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size es para .png; una página web se adapta a su pantalla.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>No se pudo hacer una imagen de los pasos.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Un archivo PDF con todos los pasos (- es la salida estándar), OUT.html para una página web en la que se puede girar el modelo, también en un teléfono, o bien OUT.png para OUT-01.png, OUT-02.png, etc.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: tantos retales del material %1 son demasiados.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Planchas de %1 que faltan: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Los pasos no están entre los archivos: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Las planchas de %1 no tienen sitio entre márgenes de %2 mm.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: se encontró «%1», se esperaba ancho x alto en mm, como 300x200, o un archivo .svg, y detrás cuántos hay, como :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Tamaño de una plancha, como 600x400; con :N detrás, cuántas hay.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: el modelo no tiene ningún material «%2»; se corta de %3.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: el modelo se corta de %2. Indica de cuál es este, como en «%3=%1».</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Una plancha de otro tamaño, o lo que queda de una como el contorno más grande de un archivo .svg a tamaño real, que se gasta antes que las enteras; con :N detrás, tantas de ellas. En un modelo de varios materiales, con el nombre del material delante: «Birch plywood=300x200». Se puede repetir.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Deja solo paredes de este ancho a lo largo de los contornos y donde otras cruzan.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Graba los números de cada unión en un color propio, el mismo en las dos piezas.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: este tipo de archivo no los admite; se esperaba %1.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Cortado una sola vez para dos piezas: %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>No coincide ningún borde de dos piezas: nada se corta una sola vez. Con --spacing 0 los bordes rectos pueden coincidir.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>Las ranuras de %1 a %2 tienen holguras de %3 a %4 mm: mete la tira y da al material la holgura de la que encaje bien.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>No hay sitio para las entradas y salidas de todos los cortes: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>Acerca de FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licencias</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Para informes de errores</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Dibuja piezas planas en 3D, mira al momento cómo encajan y córtalas. Funciona sin cuenta, y nada sale de este equipo.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Basado en «FlatFitFab: Interactive Modeling with Planar Sections», de J. McCrae, N. Umetani y K. Singh (UIST 2014). Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Con qué está hecho este programa</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Texto de la licencia</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Este programa</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Ventanas, archivos y texto</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Geometría exacta</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Vectores y matrices</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Cortar y desplazar contornos</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Leer dibujos</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Descomprimir dibujos</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modelos con imágenes y mallas</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Partes que usa CGAL</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Números sin redondeo</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Números con muchas cifras</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Resultados que pueden ser errores</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>El modelo en páginas web de los pasos</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Edición</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>Operación</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Mirar desde</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Dibujar en un plano</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Dibujar en ella</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Organizar</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Seleccionar</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Barra de adaptación</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>ahora mismo</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>hace %n minuto</numerusform>
            <numerusform>hace %n minutos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>hace %n hora</numerusform>
            <numerusform>hace %n horas</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>ayer</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>hace %n día</numerusform>
            <numerusform>hace %n días</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Anterior al dibujo</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: anterior al dibujo</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Veredictos</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>Aguanta</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>Sin doblarse</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>La sección no está</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>Tal como está, no se tiene en pie</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>Tal como está, se rompe</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistencia desconocida</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>calculando… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>no se pudo calcular</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Números de la herramienta de dibujo</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
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
        <translation>Longitud</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Afuera</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copias</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Anterior al dibujo</translation>
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
        <translation>Bien</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1 en %n sitio</numerusform>
            <numerusform>%1 en %n sitios</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 de %2: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>La revisión empieza con la primera sección.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Revisando…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Anterior al dibujo</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Todavía no hay ninguna sección que revisar.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Ningún problema.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Aún se está revisando; de momento, ningún problema.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Problema %1 de %2: %3.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Aún se está revisando. Se hará en cuanto se sepa el resultado.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>El modelo ha cambiado; esto ya no se puede hacer.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Hecho: %1.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Si haces clic: %1.</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>Problema %1 de %2, lugar %3 de %4: %5.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>Exportar a</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Buscar un comando</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Escribe lo que quieres hacer</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Comandos encontrados</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Ningún comando encontrado</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Prueba con otra palabra</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Escribir una pieza de prueba</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1, pieza de prueba</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Pieza de prueba escrita en %1. Córtala y encaja la tira en sus ranuras; Exportar te preguntará cuál encajó.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: sin holgura</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: %2 más estrecha</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: %2 más ancha</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Puentes</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>Tantas interrupciones cortas en el corte de cada pieza la sujetan en su plancha; 0: ninguna</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Ancho de los puentes</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Entrada de corte</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Cada corte empieza y termina a esta distancia de su línea, en el sobrante; 0: en la línea</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>cortar una vez</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Bordes comunes</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>De piezas que se tocan, donde la separación es 0</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Cuál de las ranuras numeradas de una pieza de prueba sujeta mejor la plancha (córtala: menú Archivo, o entre los archivos para el taller). Fija la holgura.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Ranura que encaja</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>aprox. %n min</numerusform>
            <numerusform>aprox. %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>Cotas</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Cota %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>Cambiar esta longitud escala el modelo entero</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambiar esta longitud estira %1 entre los dos puntos</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Eliminar esta cota</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Abrir un modelo</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Insertar un modelo</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Importar un dibujo</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Añadir una plantilla</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>No se ha insertado nada: %1 no tiene secciones.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Guardar el modelo</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>¿Guardar los cambios en %1?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Si no los guardas, se pierden.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>No guardar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Volver a lo guardado</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 está como se guardó. Con Deshacer recuperas tus cambios.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Abriendo %1…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Elegir otro archivo</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Quitar de la lista</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Guardando %1…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Guardar en otro sitio…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Guardado en %1.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Cambiado en el disco</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>Otro programa ha cambiado %1.</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>Si lo sobrescribes, se pierden esos cambios.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescribir</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sin título</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Dibujo</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Simetría local</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Reflejar un contorno respecto a su ranura cuando se dibuja a un solo lado de ella. Mayús hace lo contrario mientras dibujas.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Reflejar la primera</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Reflejar también la primera sección, respecto a la vertical que pasa por su inicio</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>A ras de suelo</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Cortar a ras de suelo: omitir lo que se dibuja por debajo</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>Ajustar a puntos, líneas de alineación, suelo y cuadrícula</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>La vista gira</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>Con 90° miras de frente el plano nuevo; con menos, sigues viendo la sección en la que empezaste</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Tiempo de giro</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Cuánto tarda la vista en girar hasta el plano de una sección nueva</translation>
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
        <translation>Un agujero, mientras lo dibujas</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Un contorno nuevo, mientras lo dibujas</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>Sección nueva, mientras la dibujas</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>Ahora viene su contorno</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Ranura</translation>
    </message>
    <message>
        <source>On</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>Su propia ranura</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Tramos de curva</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>lengüetas</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>cerrada</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>abierta hacia arriba, %1 de profundidad</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>abierta hacia abajo, %1 de profundidad</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>abierta hacia un lado, %1 de profundidad</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Sin reflejar.&lt;/b&gt; Las dos mitades no se tocarían en la ranura.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Sin reflejar.&lt;/b&gt; Dibujaste a un lado del eje: %1 a un lado, %2 al otro. La simetría está desactivada o tienes pulsada Mayús.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;Reflejada.&lt;/b&gt; Dibujaste a un lado del eje: %1 a un lado, %2 al otro. Crúzalo %3 o más para dibujar tú los dos lados.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Sección nueva</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Sigue</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Sobre la guía</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1 % del trazo</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Lo más lejos</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Solo un número a la vez puede seguir a un valor.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Este número no puede seguir a un valor.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Ninguna. Haz clic en una sección para omitirla o separarla.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Volver a mostrar</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Núm. %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, omitida</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1, separada</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>Exportar archivos de corte</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Abrir después la carpeta</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Piel sobre %1</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 como sólidos</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 en %2 · %3 de corte</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Exportar de todos modos</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Colocando…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Cambiar…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 y siguientes, en %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Reemplaza %1 en %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>la carpeta personal</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Plancha %1 de %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Lista de piezas</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Plancha anterior (RePág)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Plancha siguiente (AvPág)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>Mostrar la plancha entera</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Una piel no tiene planchas: el archivo contiene la forma que sugieren las secciones, como una superficie sobre sus contornos.</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>Los sólidos no tienen planchas: el archivo contiene el modelo tal como está, a tamaño real y con sus ranuras.</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Plancha %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>No hay nada que cortar.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Aprovechado: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Colocando las piezas en planchas…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>¿Qué material?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Medir otra vez</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Grosor medido</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Mide con un calibre la plancha que vas a cortar: las ranuras se dibujan a su medida.</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>¿Qué plancha?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Ancho de la plancha</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Alto de la plancha</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, %2 de grosor</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Tamaño propio</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>¿Qué máquina?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Colores, capas, velocidades y G-code como los toman esta máquina y su programa, y lo que quita de cada material</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, medido %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>Es lo que he medido</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>Primero se gasta %n retal.</numerusform>
            <numerusform>Primero se gastan %n retales.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Cualquier láser</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Ninguna pieza está sobre un retal.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>Primero se gasta %1 de %n retal.</numerusform>
            <numerusform>Primero se gastan %1 de %n retales.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2 veces</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>No se puede cortar</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Revisando…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Nada que tener en cuenta.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Una plancha de %1 no tiene sitio entre márgenes de %2.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>El ancho de corte de %1 es 0: las ranuras quedan más anchas y las piezas más pequeñas, según lo que quite la máquina.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>Las planchas son más grandes que la cama de %1, de %2. Elige otras más pequeñas.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Encaje</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Ancho de corte (total)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Holgura de ranuras</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Ancho dibujado</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Distribución</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Margen en el borde</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Cuartos de vuelta para planchas con veta</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm, debajo de las planchas</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Barra de medida</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Dibujada junto a las planchas, no se corta: mídela en tu máquina para comprobar el tamaño</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Cualquier ángulo</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Cuartos de vuelta</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Medias vueltas</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Como está dibujada</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Se guarda para este material y la máquina elegida</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>un color por unión</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Números de unión</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>Las dos piezas de una unión llevan su número en el mismo color: para papel y para máquinas a las que se dice qué hacer con cada color</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>¿No estás seguro? Corta antes una pieza de prueba…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>Las ranuras de %1 no dejan nada de ella. No se corta.</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 es más grande que la plancha. Va en una plancha de su propio tamaño.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 es demasiado delgada para llevar su número.</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 tiene un agujero o una muesca más estrechos que el ancho de corte, que no se cortan.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 no tiene sitio para los números de todas sus uniones.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n pieza</numerusform>
            <numerusform>%n piezas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n plancha</numerusform>
            <numerusform>%n planchas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Exportando %1…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>Exportado a %3: %1 en %2.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>Exportado a %3: %1 en %2; las ranuras se dibujan de %4 de ancho.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>Exportado a %3: %1 en %2; las ranuras se dibujan de %4 de ancho (%5 − %6 de ancho de corte).</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>Exportado a %2: %1 como sólidos.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Piel exportada a %1; queda abierto %n hueco.</numerusform>
            <numerusform>Piel exportada a %1; quedan abiertos %n huecos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Piel exportada a %1.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiales…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Exportar a otro sitio…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Siguen ahí planchas de una exportación anterior: %1.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>No se ha exportado: los archivos que hay se quedan.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>Hace falta %n plancha de %1 más de las que hay.</numerusform>
            <numerusform>Hacen falta %n planchas de %1 más de las que hay.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Falta un número.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>«%1» no se puede leer aquí.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Falta algo después de «%1».</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Un paréntesis no está cerrado.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>Sobra un paréntesis de cierre.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>No se puede dividir entre 0.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>No hay ningún valor llamado «%1».</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>Esto no es una longitud; multiplica una longitud por un simple número.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>Esto no es una masa; multiplica una masa por un simple número.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>«t» es el grosor del material; aquí no hay un único material.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>No se ha abierto nada: no se indicó ningún archivo.</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 no es un modelo. FlatFitFab abre %2.</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>%1 no se pudo abrir: ya no está en %2. No ha cambiado nada.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>%1 no se pudo abrir: %2. No ha cambiado nada.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>%1 no se pudo abrir: %2 (%3). No ha cambiado nada.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>El archivo del disco sigue siendo el anterior.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>No se ha escrito nada.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>la carpeta %1 no existe</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>No se ha exportado: %1. %2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>No se pudo guardar %1: %2. %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>Lo es en cuanto mueves uno de sus puntos</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Su centro, en las coordenadas de la sección</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Agujero %1</translation>
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
        <translation>Forma libre</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>Archivo de corte</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Papel o imagen</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Sólidos para imprimir o renderizar</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Lista de piezas</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Todo para un taller</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>¿Qué archivo?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>¿Para qué es?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Un archivo por plancha</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Calcar</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Está en</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Tumbarla en el suelo</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Ponerla de pie, para verla de frente</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Ponerla de pie, para verla desde la derecha</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Ponerla en la sección seleccionada, con la que se mueve</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Voltear</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Como se ve desde detrás</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Alinear dos</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>Las dos últimas imágenes como frente y lado de una misma cosa: igual de altas y sobre el mismo punto</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>Lo oscuro que tiene que ser para calcarlo</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>Cuánto se redondean las esquinas</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contornos</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Hacer secciones</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Secciones de sus contornos, en su propio plano</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Cortar agujeros</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Agujeros en la sección en la que está o que está seleccionada</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Líneas en la sección en la que está o que está seleccionada</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: demasiados para secciones</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>se abre, %1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n unión se abre, hasta %1&#x202f;N</numerusform>
            <numerusform>%n uniones se abren, hasta %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modelos (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Dibujos (%1)</translation>
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
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Afuera</translation>
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
        <translation>Copia: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>Guardar las teclas en una página</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documentos PDF (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>Teclas de FlatFitFab</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>No se pudo escribir %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Todos los pasos; al elegir uno se vuelve a él.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Aquí aparecerán todos los pasos; podrás volver a cualquiera de ellos.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>De vuelta al principio. Haz clic en un paso posterior para rehacerlo.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>El modelo está como estaba tras «%1».</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Como se abrió</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Modelo nuevo</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Guardado aquí</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Supr quita una sección; arrastrar, o Alt con una flecha, cambia el orden.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Quitarla</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (eliminada)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
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
        <translation>Hecha por una operación</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Hecha por</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Imagen de</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>Omitir esta</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>Convertir esta en una sección dibujada; su operación sigue haciendo las demás</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Hecha a partir de</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>Los cambios en una de ellas se aplican a todas</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>Redibújala; todo lo que sale de ella la sigue</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Unión</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Ranuras</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Restablecer lo automático</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secciones</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>Se abre</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Invertir las ranuras</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Ranura</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
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
        <translation>Punto de encuentro</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>lengüeta, %1 de ancho</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>cerrada, %1 de largo, %2 de ancho</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>%1 de profundidad, %2 de ancho</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 y %2 se solapan.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Recortar %1</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Punto de encuentro %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>La ranura de %1 ocupa esta parte de la profundidad, la de %2 el resto</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Puesto a mano; lo automático es 50&#x202f;%. %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Secciones: %1 y %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Puesto a mano; se puede restablecer lo automático</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 se abre</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>El lado hacia el que se abre la ranura de %1; la de %2 se abre hacia el otro</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>En %1</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Dejar que el programa vuelva a elegir el tipo, la dirección y los puntos de encuentro</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>En esta unión no hay nada puesto a mano</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>Seleccionar la unión con %1</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Aún ninguna</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>media madera</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>media madera larga</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>mortaja</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>lengüetas</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>sin unión</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>Media madera</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>Media madera larga</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Mortaja</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Lengüetas</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>La holgura de su material deja una ranura sin ancho</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>Las ranuras no se pueden abrir hacia fuera: lo impide un agujero</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>En un sitio solo podrían deslizarse en un sentido y en otro, solo en el contrario</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Nada las sujetaría: hay agujeros donde empezarían las ranuras</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>Una sección sobresale de la otra, se deslicen como se deslicen</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Ninguna sección sobresale de la otra</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Se cruzan en más de un sitio</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Ninguna sección pasa por una ranura cerrada de la otra</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>Una sección solo termina en la otra</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Ninguna sección termina en la cara de la otra</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>No hay sitio para lengüetas y sus ranuras</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Se cruzan con menos de 30°</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>A la derecha</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>A la izquierda</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Pulsa las teclas</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>Guardarlas en una página para imprimir…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>En la vista</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>Dibujar la primera sección</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>arrastrar en el centro</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Dibujar una sección que cruce otra</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>arrastrar hacia fuera y seguir</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Girar la vista</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>arrastrar junto al modelo</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Acercarse</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rueda</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Mover la vista</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>arrastrar con el botón central</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Seleccionar un grupo</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>Mayús y arrastrar</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Ver qué se puede hacer</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clic derecho</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Añadir un punto</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>doble clic en el contorno</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Dibujar sin ajustar</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>mantener Ctrl</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Distribución</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plancha</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Piezas en agujeros</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>Las piezas pequeñas pueden ir en los agujeros de las grandes</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
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
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteca</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Añadir selección</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>Poner la selección en la biblioteca; si no la hay, el modelo entero</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>Elegir la carpeta cuyos modelos se muestran aquí</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>Aquí aparecen las piezas que guardes: selecciona unas secciones y haz clic en Añadir selección.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Carpeta de la biblioteca</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>No se ha añadido nada: aún no hay nada dibujado.</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>No se puede crear la carpeta de la biblioteca, %1.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 ya está en la biblioteca.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 está en la papelera.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>No se pudo mover %1 a la papelera.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Añadirla al modelo</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>Mover a la papelera</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadPage</name>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Empuje</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Dónde actúa</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Simple peso</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>También en kg, oz o lb: 1,5 kg, 2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Agua que contiene</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Centro de masas</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>Altura sobre su posición: cuanto más alto, antes vuelca el modelo</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N es más o menos lo que pesa 1 kg</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Dirección X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Dirección Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Dirección Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>En</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>En el plano de la sección, desde su origen</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Posición X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Posición Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Reparto</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>En un punto</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>En una zona</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>A lo largo del borde</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Colgado</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>También en copias</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Cada copia que las operaciones hacen de su sección lleva otro igual</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Pesos y empujes</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 renombra, Supr quita.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Empujes</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Empuje</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
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
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Atraída</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Curvar la plantilla hasta el plano de esta sección, para que las guías de las demás sigan lo dibujado</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>A menos de</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Barra de herramientas</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Repetir secciones y hacer transiciones</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>No se puede mostrar el modelo: el controlador gráfico no ofrece OpenGL 3.3. Puede ayudar un controlador más nuevo.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>No se puede mostrar el modelo en esta pantalla.</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Empieza un modelo nuevo, sigue con otro o mira un ejemplo.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Recuperado: %n modelo sin guardar</numerusform>
            <numerusform>Recuperados: %n modelos sin guardar</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Mostrarlos</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Recuperado: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Abrirlo</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Mostrar la carpeta</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Este modelo está aquí para adaptarlo. «Editar el diseño» lo recupera todo.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Ayuda: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Sugerir secciones</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Cuántas</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Sugerir</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Busca secciones que muestren su forma, se sujeten entre sí y se tengan en pie</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Una más</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Una sección que encaje entre las que hay</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Otras</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>Otras secciones en lugar de las últimas</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetas</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Caras</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Hacer facetas</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>La construye con planchas planas que tienen dientes en los bordes. Antes se simplifica la malla a este número de caras; las que están juntas en un plano son una sola plancha.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Desplegar</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>La despliega en plano, para cortarla de cartulina en una o pocas piezas y plegarla por líneas rayadas. Los bordes que se unen llevan el mismo número.</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>Marcas</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Marca %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Grabada</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Rayada</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Eliminar esta marca</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Altura de letra</translation>
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
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 es demasiado grande para un modelo, así que ahora mide %2. Su tamaño está en Plantillas.</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 no tiene unidad, así que ahora mide %2. Su tamaño está en Plantillas.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Mallas, imágenes y dibujos (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Imagen pegada</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>A la escala de %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Y %n más.</numerusform>
            <numerusform>Y %n más.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>aún no hay nada dibujado</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Secciones nuevas</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Material de las próximas secciones que dibujes</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Editar el material</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>Muestra, exagerado, dónde se dobla o se suelta el modelo. No cambia nada.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>El movimiento está reducido: usa el control deslizante</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>No se sabe cómo se mueve.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>Activa «Flexión» para ver cómo se dobla.</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Se muestra cómo empieza a separarse.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Se dobla %1, mostrado %2 veces mayor.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Se dobla %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>Valores con nombre</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Un nombre es una palabra de letras y cifras, distinta de «t» y de las unidades.</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Eliminar este valor</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Sección %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>Al menos %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>Como máximo %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Retal</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Una plancha de otro tamaño, que se gasta antes que las enteras</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>De un dibujo…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>Lo que queda de una plancha, como el contorno más grande de un archivo SVG a tamaño real, con sus agujeros</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Ancho del retal</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Alto del retal</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Cuántos de este retal</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Quitar este retal</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, de un dibujo</translation>
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
        <translation>Elegir otra</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostrarla</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Permitir más</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Dejarla así</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Elegir</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Excepciones</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Convertir</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Convertir en secciones dibujadas lo que hace; la operación desaparece</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>Eliminarla junto con todo lo que hace</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Elegir</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Permitir más</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Operaciones, en orden</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 renombra, Espacio oculta y muestra, Alt con una flecha cambia el orden.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Oculta: mostrarla</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ocultarla</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Esquema</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Filtrar por nombre o material</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secciones</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 renombra, Espacio oculta y muestra.</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>Las secciones aparecen aquí a medida que las dibujas.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, dibujándose</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Bloqueada: desbloquearla</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>Bloquearla</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Oculta: mostrarla</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ocultarla</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Dibuja aquí una forma con el botón izquierdo pulsado.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, y %n más aquí</numerusform>
            <numerusform>%1, y %n más aquí</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Calculando las ranuras…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 desde el último punto</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>Reflejada respecto a la ranura</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>Reflejada respecto a la vertical</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Cortada a ras de suelo</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Suelo %1 bajo este borde</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Ranura %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Ranura %1, %2</translation>
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
        <translation>Tal como resulta de las secciones</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Puesto a mano</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Lista de piezas</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Núm.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Cantidad</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>Física</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Líneas de tensión</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Mostrar desde</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Parte de la resistencia de la plancha; lo que está por debajo no se muestra</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>elementos finitos</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Flexión</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Donde varias uniones comparten una carga, la rigidez de las secciones decide cuánto lleva cada una. Tarda un rato.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Resistencia</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Colorea la sección seleccionada según la masa que aguanta cada punto, además de lo que ya lleva el modelo. Tarda un rato.</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Puntos más débiles</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Cargas</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Pon un peso en el modelo para ver cuánto aguanta.</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Peso propio</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>En el suelo</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Añadir peso</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Añadir empuje</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Exigencia</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Factor de seguridad</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>Cuántas veces su carga debe poder soportar el modelo para que se dé por bueno</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Factor de entalla máx.</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>Cuánto aumenta la tensión en las esquinas interiores depende de la longitud de la parte más estrecha, hasta este factor; las ranuras de extremo redondo necesitan menos</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>durante meses</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>La carga sigue</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Un material aguanta entonces menos, lo que se indique en él: el acrílico, solo una cuarta parte</translation>
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
        <translation>Quitar este empuje</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Quitar este peso</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>calculando… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>no se pudo calcular</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>la sección seleccionada</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>selecciona una sección</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Dibuja una sección para ver cuánto aguanta.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>No se pudo calcular si aguanta.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Anterior al dibujo, calculando…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>No se tiene en pie; no se muestra la tensión.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Se abre una unión; no se muestra la tensión.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Resistencia desconocida: un material está sin valorar. Indica su resistencia en Materiales.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>Al día. Las uniones pueden repartirse la carga de muchas maneras; cuenta la peor.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>Al día. Todas las fuerzas se equilibran.</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Se dobla %2.</translation>
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
        <translation>respecto a su ranura</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>respecto a la vertical</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>respecto a la horizontal</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>No se mueve con la sección en la que está ni conserva su ángulo con ella</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueada</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Se queda como está, salvo que se mueva la sección en la que está</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simétrica</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>Los cambios en los puntos de una mitad se aplican a la otra</translation>
    </message>
    <message>
        <source>On</source>
        <translation>En</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Haz clic en otra sección para ponerla en ella</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>No está en otra sección</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Ángulo de unión</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Sigue</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>en proporción</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>a su extremo izquierdo</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>a su extremo derecho</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>a su extremo inferior</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>a su extremo superior</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Cómo se desplaza cuando un valor estira la sección en la que está: en la misma proporción, o manteniendo su distancia a un extremo</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X de su centro</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y de su centro</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z de su centro</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X de la dirección hacia la que mira, de longitud 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y de la dirección hacia la que mira, de longitud 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z de la dirección hacia la que mira, de longitud 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Mira hacia</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>Tirador de entrada</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Ángulo de entrada</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Tirador de salida</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Ángulo de salida</translation>
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
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simétrico</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>cambiado</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nombre del preajuste</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, cuatro baldas …</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Conservar como preajuste lo que está puesto ahora</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Eliminar este preajuste</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Conservar como preajuste</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Da un nombre, como A5, a lo que está puesto ahora, para volver a ello</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 fuera</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 dentro</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 por encima</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>%n más en Revisión.</numerusform>
            <numerusform>%n más en Revisión.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Activa</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Desactivada, no hace nada, pero conserva todo lo puesto en ella</translation>
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
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>No hay nada seleccionado</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Los cambios se aplican a todas ellas</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Se solapan</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automático</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · puesto a mano</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n unión</numerusform>
            <numerusform>%n uniones</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Hecha por %1 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Sección · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Sección · en %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · desactivada</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · no hace nada</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · al día</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir reciente</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (no se encuentra)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Vaciar esta lista</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Olvidar estos nombres; los archivos se quedan</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>A tener en cuenta</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Cierra esto y lo selecciona en el modelo</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Reemplazar archivos</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>¿Reemplazar %n archivo que ya existe?</numerusform>
            <numerusform>¿Reemplazar %n archivos que ya existen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>¿Reemplazar este archivo?</translation>
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
        <translation>A lo largo de una costilla, de aro a aro</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>A lo largo de una costilla, hasta el aro inferior</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Arco</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>desvío</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>eje_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>eje_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dorso</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Viga</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Vigas</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>Costilla del vientre</translation>
    </message>
    <message>
        <source>between</source>
        <translation>entre</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Estante</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Estantes</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>estantes</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Rama</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>mayúscula</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Celdas</translation>
    </message>
    <message>
        <source>column</source>
        <translation>columna</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>columnas</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Cuna</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>cuna</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Copete</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Cubiertos</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>fondo</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diámetro</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Separador</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Separadores</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Orejas</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Base de atrás</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Bailarín de atrás</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Bailarín de atrás, inclinado</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Bailarines de atrás</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Abeto</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Abeto cruzado</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pie</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Patas delanteras</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Tenedores y cucharillas</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Cuatro estantes</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>De eje a eje, en horizontal</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>De eje a eje, con algo de holgura</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>De pared a pared</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Pie delantero</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Patas delanteras</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Travesaño delantero</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Ola delantera</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Vaso de agua</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Asa</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Altura de las mayúsculas; un nombre largo tiene que ser más pequeño</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Altura de las cunas</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Altura del eje del piñón</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Altura del eje de la rueda</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Pie trasero</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Patas traseras</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Ola trasera</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Cadera</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Cuernos</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>Cuánto se desvía una costilla de su sitio de abajo al llegar al aro superior</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>Cuánto se inclina cada costilla</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>Cuánto más bajo queda el piñón, visto desde la rueda</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Ancho de la placa, en alturas de una mayúscula</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Su ancho</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Frascos</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Última costilla</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Pata izquierda</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Hoja izquierda</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Lateral izquierdo</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Tira izquierda</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Ala izquierda</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Pata</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Patas</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>patas</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>letras</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Pie largo</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Aro inferior</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Listón inferior</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Base del medio</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Bailarín del medio</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Bailarín del medio, inclinado</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Bailarines del medio</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Costilla central</translation>
    </message>
    <message>
        <source>module</source>
        <translation>módulo</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Taza</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Hocico</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Placa con nombre</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Base del frente</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Bailarín del frente</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Bailarín del frente, inclinado</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Bailarines del frente</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Cuello</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>De una costilla, a lo largo</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>De los estantes, de punta a punta</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Del cajón, por dentro</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Del vaso</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>De la pared más alta</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Del piñón, desde un hueco hasta la rueda</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Del piñón, de igual modo</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>De los laterales</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>De los laterales; el copete queda más alto</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>De la rueda</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>De la rueda, hasta el fondo de sus huecos</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>De la rueda, hasta la punta de sus dientes</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Otro pie</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Otro pilar</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Otro pasamanos</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Otro lateral</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Otro larguero</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Otra puntera</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Bolígrafos</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>fase</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>Pilar</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Piñón</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>piñón</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Dientes del piñón</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>radio_piñón</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>raíz_piñón</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>piñón_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Placa</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>placa</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Placas</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>radio</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Pasamanos</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Radio de aleta</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Radios de aleta</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Costilla trasera</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>resto</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Costilla</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Costillas</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>costillas</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Pata derecha</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Hoja derecha</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Lateral derecho</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Tira derecha</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Ala derecha</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Aro</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Corona de agujeros</translation>
    </message>
    <message>
        <source>root</source>
        <translation>raíz</translation>
    </message>
    <message>
        <source>row</source>
        <translation>fila</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Filas</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>filas</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Tornillos</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Asiento</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Bandeja</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Hombro</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lateral</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Laterales</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Larguero</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Tamaño de los dientes: el diámetro dividido entre cuántos hay</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Rebanadas</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Vaso pequeño</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Espinazo</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Cucharas y cuchillos</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Cola</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Dientes</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>dientes</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Dientes del piñón</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>Lo mismo sin los dientes enteros</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Tres estantes</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>inclinación</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Cuaderna</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>Cuadernas</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>Puntera</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Diente</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Tronco</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>Vaso</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>giro</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Ramita</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torsión</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Aro superior</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Listón superior</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Vértebras del cuello</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Vértebras de la cola</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Ballena</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>Lo que cabe en la plancha</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Dónde está un diente de la rueda</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Ancha</translation>
    </message>
    <message>
        <source>width</source>
        <translation>ancho</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>anchos</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Pez</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Perro salchicha</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Abeto</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Pantalla de lámpara</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Silla de muñecas</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Portavasos</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Organizador de escritorio</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Estantería</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Organizador de cajón</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Placa con nombre</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Soporte para vaso</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Oso sobre una malla</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Búho a partir de imágenes</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Erizo en rebanadas</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Raspa de pescado</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinosaurio</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Ciervo volante</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Árbol que crece</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Bailarines en dos poses</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Pasarela</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Engranajes</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Ballena en celdas</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Hombre de los cubiertos</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Vaso sobre tres patas</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Tres patas finas: demasiado débil</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Cuatro patas finas: demasiado débil</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Tres patas gruesas: por poco</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Cuatro patas gruesas: seguro</translation>
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
        <translation>empezar crear comenzar vacío blanco</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>cargar importar flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>añadir agregar combinar fusionar juntar</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>almacenar escribir grabar</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>copia renombrar</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>recargar descartar restaurar</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>imprimir láser laser cortadora cnc plotter svg dxf pdf gcode lightburn hacer fabricar</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>ajustes opciones configuración configurar oscuro claro tema idioma unidades pulgadas ratón navegación autoguardado animación</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>teclas teclado combinaciones</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>cerrar terminar abandonar</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf importar</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf importar grabar</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj imagen foto calcar referencia fondo</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>atrás volver ups</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>repetir otra vez adelante</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>portapapeles</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>copiar clonar</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>voltear espejo simétrico</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>quitar borrar suprimir papelera</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>todas</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>encontrar búsqueda paleta</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoom centrar inicio</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom enfocar</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>mirar recto perpendicular</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>ortográfica isométrica paralela cámara</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>transparente alambre través</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>cortar interior mitad</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>superficie cáscara cubierta</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>solo sola</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>visible ocultas</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>invisible esconder</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>cuadrícula rejilla piso</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>pasar dar personalizar personalizador configurar alumno estudiante clase ajustar deslizadores bloqueado ventana</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>maximizar</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>barras laterales</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>disposición predeterminado</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>espejo mitad</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>piso pies base</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>imán alinear guía</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>polígono línea curva bézier bezier trazado</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>círculo cuadrado rectángulo polígono estrella ojal</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>grabado texto letras etiqueta rotular</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>mover rotar girar escalar tamaño</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>abertura ventana hueco recorte</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>reemplazar sustituir</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>lineal matriz patrón repetir serie costillas</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>revolución girar alrededor</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>solevación loft interpolar entre mezcla</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>árbol bifurcación ramificar</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>waffle caja rejilla celosía</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>radios rueda engranaje polar</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>rotar polar patrón giro</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>matriz patrón repetir copias</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>waffle capas stl láminas cortes</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>explotar aplicar transformar</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>error advertencia fallo</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>montaje instrucciones animación reproducir manual ensamblar</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>resistencia romper simulación física fem esfuerzo</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>carga masa fuerza</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>fuerza carga</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>material grosor espesor contrachapado madera acrílico metacrilato kerf</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>prueba probeta kerf holgura ranuras peine</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>nesting anidado distribución colocar</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>longitud distancia tamaño cota regla</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>escalar tamaño redimensionar</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>manual tutorial documentación guía</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>inicio bienvenida ejemplos</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>versión licencia</translation>
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
        <translation>Uniones</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Editar el material</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Grosor del material: todas las secciones de este material lo siguen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Como todas las demás</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Cómo se pueden girar sus piezas en la plancha: la que sigue la veta va como está dibujada o con medias vueltas</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Otra longitud estira el contorno desde su ranura o desde su centro</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Agujeros</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
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
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Grupos de preferencias</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Teclado</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Milímetros (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centímetros (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Pulgadas (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>Lo que se muestra y se escribe. Los archivos siempre contienen milímetros.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Alto contraste</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Se aplica al reiniciar.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Mostrar la página de inicio al arrancar</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Tiempo de giro</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Cuánto tarda la vista, mientras dibujas, en girar hasta el plano nuevo. Con 0, salta.</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>La vista gira</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>Con 90° miras de frente el plano nuevo. Con menos, sigues viendo la sección en la que empezaste.</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>Los trazos siguen una plantilla a menos de</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Botones del ratón como en</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Qué botones giran, mueven y acercan la vista. Ctrl con el botón izquierdo siempre la gira, Espacio con el botón izquierdo la mueve.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Siempre</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>Lo menos posible</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Con lo menos posible, la vista salta en lugar de girar.</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Colores de tensión para daltónicos</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>De claro a oscuro en vez de azul a rojo. Siempre así en alto contraste.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Avisar de ángulos menores de</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Cuanto menor es el ángulo entre dos secciones, más anchas tienen que ser sus ranuras.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Ignorar solapes menores de</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Un solape menor que esto no es un problema.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Buscar orden de montaje durante</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>En segundo plano, después de cada cambio. Da más tiempo si la revisión no encuentra ningún orden.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Factor de seguridad</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>Cuántas veces su carga tiene que aguantar un modelo para que se dé por bueno.</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Factor de entalla máx.</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>Cuántas veces mayor se supone la tensión en las esquinas interiores.</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>Las cargas duran meses</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Respaldar lo no guardado cada</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Tras un fallo o un corte de luz lo recuperas, aunque nunca se haya guardado. Tu archivo no se toca.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Conservar la versión anterior al guardar</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Ventana sencilla</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Para dibujar, revisar y exportar; lo demás no estorba.</translation>
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
        <translation>Carta</translation>
    </message>
    <message>
        <source>K40 laser</source>
        <translation>Láser K40</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>Tablero entero</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>En la plancha</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plancha</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Posición X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>se queda en su sitio</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Fijada</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P fija y suelta la pieza seleccionada en las planchas</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>no cabe en ninguna</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, su primera pieza</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm, para comprobar el tamaño</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Plancha, tal como se cortará</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Más y menos acercan y alejan, las flechas la mueven, Inicio la muestra entera.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>El retal de %1 queda entero</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Planchas</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rápida</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Buena</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>La mejor</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Lo bien que se colocan las piezas</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Rápida vuelve a colocar todas las piezas. Buena tarda unos diez segundos. La mejor sigue hasta que la detienes.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Dividir con Cuadrícula</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Soltar todas</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Dibuja una sección y aparecerá aquí, lista para cortar.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Colocando…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Colocando otra vez…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n pieza fijada no tenía sitio donde estaba.</numerusform>
            <numerusform>%n piezas fijadas no tenían sitio donde estaban.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 no cabe en su plancha.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 y %n más no caben en sus planchas.</numerusform>
            <numerusform>%1 y %n más no caben en sus planchas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Añadir un retal</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n plancha más de las que hay</numerusform>
            <numerusform>%n planchas más de las que hay</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · %2 de corte</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>conserva la mejor hasta ahora, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Colocando… %1 % aprovechado</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 en %2 · %3 % aprovechado · %4 de corte</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Planchas, tal como se cortarán</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>RePág y AvPág van de una pieza a otra, las flechas mueven una pieza 1 mm, R la gira, P la fija. Más y menos acercan y alejan, Inicio muestra todas las planchas.</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · girada %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>No hay sitio para ella.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>No se puede girar tan poco.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Va como está dibujada.</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Plancha %1 de %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>No cabe</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>veta ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n pieza · %1 % ocupado</numerusform>
            <numerusform> · %n piezas · %1 % ocupado</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Retal, plancha %1 de %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Fijada: se queda donde está. Haz clic para soltarla.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Arrastra una pieza a otro sitio o haz clic en ella para seleccionarla.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Haz clic para soltar &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; es demasiado grande para su plancha. Haz clic para seleccionarla.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Arrastra &lt;b&gt;%1&lt;/b&gt; a otro sitio o haz clic para seleccionarla.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Arrastra &lt;b&gt;%1&lt;/b&gt; a otro sitio. &lt;kbd&gt;R&lt;/kbd&gt; la gira, &lt;kbd&gt;P&lt;/kbd&gt; la fija.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtrar por nombre o teclas</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Sin teclas para este comando</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>Las teclas originales de este comando</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>Las teclas originales de todos los comandos</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>Usarlo aquí</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Los comandos y sus atajos</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Funciona</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>en la vista</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>en todas partes</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Elige un comando</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Teclas para %1:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Cambiado por ti</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 a solas estorbaría al escribir. Púlsala con Ctrl o Alt; las teclas sueltas son para comandos que funcionan en la vista.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 es de «%2».</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Entre %1 sobresaldría mucho: una sección más que cruce dirá cuánto.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Entre %1 se doblaría sobre sí misma.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Lo que hay entre %1 no se deduce de sus contornos.</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Piel: calculando… %1&#x202f;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Piel: calculando…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Piel: detenida</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Piel: no se pudo calcular</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Piel: nada que cubrir</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Piel: no se cruzan contornos</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Haz clic para detener.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Una piel necesita secciones que se crucen y que terminen ahí en el mismo punto.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n parche</numerusform>
            <numerusform>%n parches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; queda abierto %n hueco.</numerusform>
            <numerusform>%1; quedan abiertos %n huecos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Haz clic para volver a ver solo las secciones.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Recto</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redondo</translation>
    </message>
    <message>
        <source>Dogbone</source>
        <translation>Hueso de perro</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>Hueso en T</translation>
    </message>
    <message>
        <source>Slit end</source>
        <translation>Fin de ranura</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>El extremo interior de una ranura. Un láser lo corta recto; la fresa, que es redonda, no llega a las esquinas. Redondo: un fondo redondo más allá del recto. Hueso de perro: un arco en cada esquina. Hueso en T: un arco en cada pared; el fondo queda plano.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Fresa</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Diámetro de la fresa. Los arcos se dibujan algo más grandes, para que pueda recorrerlos.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Un final recto no usa fresa. Para una fresadora, elige otro fin de ranura.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Chaflán</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Chaflán a 45° de las dos paredes en la boca de una ranura, para que las secciones entren con facilidad. Lo habitual es entre la mitad del grosor y el grosor entero; 0: ninguno.</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Resaltes</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Altura de un pequeño resalte en cada pared de una ranura, que aprieta la sección que entra en ella. Tiene que ser más de la mitad de la holgura; 0: ninguno.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>sección</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>sección generada</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>en %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueada</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>tiene un problema</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>ningún problema</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Unión entre %1 y %2</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, operación</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 en %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n sección seleccionada</numerusform>
            <numerusform>%n secciones seleccionadas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuevo</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Dibuja tu propio modelo</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Abrir un modelo, también de FlatFab</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Sin cuenta; nada sale de este equipo.</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Mostrar al arrancar</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Abrirlo</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Recuperado: %1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Mostrar la carpeta</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>no se encuentra</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Quitar de esta lista</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>Abrir una copia</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Tu primer modelo en 3 minutos</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Dibujar, revisar y cortar un modelo, paso a paso</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>Qué hace el próximo gesto</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Número de secciones</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Tamaño del modelo</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Masa del modelo</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Unidad de todas las longitudes</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>Deshecho: «%1».</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>Deshecho: «%1». &lt;kbd&gt;%2&lt;/kbd&gt; lo recupera.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>Rehecho: «%1».</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>Rehecho: «%1». &lt;kbd&gt;%2&lt;/kbd&gt; lo deshace.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Pasos del montaje</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Exportar pasos…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Cerrar los pasos (Esc)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Paso anterior (Izquierda)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Reproducir (Espacio)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Paso siguiente (Derecha)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>Separar las piezas</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Despiece</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pausa (Espacio)</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Escribir todos los pasos en un PDF para imprimir, en una página web para teléfonos, o una imagen de cada uno</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Todos los pasos, para imprimir (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Imágenes, una por paso (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Exportar pasos</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Exportando %1…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>No se ha escrito nada: la exportación se canceló.</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>No se pudieron exportar los pasos: en esta pantalla no se puede hacer ninguna imagen.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n paso</numerusform>
            <numerusform>%n pasos</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>Exportado a %2: %1.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>Exportado a %2 … %3: %1.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Exportar a otro sitio…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Página web (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>Este navegador no muestra el modelo en 3D. Aquí está lo que hay que hacer, paso a paso.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>No hay imágenes: no se pudo hacer ninguna en la pantalla del ordenador que escribió esta página.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Arrastra para girar el modelo, pellizca o usa la rueda para acercarlo, toca dos veces para verlo entero.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Paso anterior</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Paso siguiente</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Piezas</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 pieza</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pieza</numerusform>
            <numerusform>%n piezas</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 plancha</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n plancha</numerusform>
            <numerusform>%n planchas</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 paso</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n paso</numerusform>
            <numerusform>%n pasos</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>Cómo se monta</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, de %2, en %3.</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>Los números son los que van grabados en las piezas. Junto a cada ranura está, tras una rayita, el número de su unión, el mismo en sus dos piezas.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
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
        <translation>El modelo ha cambiado, por eso no se muestran sus pasos.</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>No se pueden mostrar los pasos en esta pantalla.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>Los pasos no se mostrarán.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>Calculando el orden de montaje; los pasos se mostrarán en cuanto se conozca.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>No se pueden mostrar los pasos: %1.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>Ya se conoce el orden de montaje; «Ver los pasos» lo muestra.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Aún no hay nada.&lt;/b&gt; Paso 1: %1</translation>
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
        <translation>Contrachapado de abedul</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Contrachapado de abedul 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Contrachapado de abedul 6,5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Contrachapado de abedul 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>Acrílico</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>Acrílico transparente</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Acrílico rojo</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Cartón ondulado B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Cartón ondulado C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Cartón ondulado E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Cartulina</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Tilo</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM</translation>
    </message>
    <message>
        <source>Aluminium 6061</source>
        <translation>Aluminio 6061</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Use %1 for new sections</source>
        <translation>Usar %1 en las secciones nuevas</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: %2 → %3 de grosor</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Material de la próxima sección</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Material de la próxima sección: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiales…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Materiales</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Plancha</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Ancho × alto</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>no se conoce</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 significa que no se conoce</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Precio de plancha</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Ancho de la plancha</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Alto de la plancha</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Planchas habituales</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Resistencia</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Resistencia a tracción</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Resistencia a flexión</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>antes de romperse</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Se dobla</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Como el metal: por encima de estas resistencias se queda doblado</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Aguanta meses</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Parte de su resistencia bajo una carga que permanece: el acrílico cede y se agrieta</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Ancho de corte (total)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Holgura de ranuras</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Ancho dibujado</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Ranuras</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>sin valorar</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 significa sin valorar</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>No hay secciones hechas de él</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>ninguno: el ancho de corte es mayor que la ranura</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Grosor, holgura y ancho de corte de dos secciones de este material en ángulo recto</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Se vende como</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>El grosor con el que se compra la plancha; por lo general no es exactamente ese</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>con calibre, por mí</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>Al exportar se pregunta una vez qué grosor tienen las planchas que va a cortar</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>tantas como hagan falta</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 significa tantas como hagan falta</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Cuántas hay</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Se gastan antes</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Un retal de un dibujo</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Dibujos (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Por máquina</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Se guarda donde se escribió un ancho de corte mientras esa máquina estaba elegida al exportar</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Tamaño y cantidad</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Materiales de este modelo</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Añadir un material de los predefinidos</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Añadir un material con los mismos números</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Guardar este material en un archivo, para otros modelos y otras personas</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Guardar el material en un archivo</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Quitar el material</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Un modelo necesita un material; añade antes otro</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Quitar este material</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>De un archivo…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Añadir un material de un archivo</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>Modelos de FlatFitFab (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Hacer su %n sección de</numerusform>
            <numerusform>Hacer sus %n secciones de</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Añadir el material %1</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Quitar el material %1</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
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
        <translation>En lo más estrecho</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>En su esquina</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>Doblada en su plano</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Doblada a través</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>Comprimida</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>Estirada</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Cizallada</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Retorcida</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>Tan esbelta que puede pandear antes de romperse.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Dudoso: actúan fuerzas junto a los agujeros que cruza.</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Cifra aproximada: la parte más estrecha es demasiado corta o está demasiado cerca de una fuerza.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Se agrietaría primero por su esquina.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Se rompería de lado a lado.</translation>
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
        <translation>Tensión</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Factor de seguridad %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistencia desconocida</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Nada por encima del %1&#x202f;%</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>Movimiento %1&#x202f;×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>No se tiene en pie; no se muestra la tensión.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Se abre una unión; no se muestra la tensión.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>No se pudo calcular si aguanta.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Buscando secciones…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Haciendo facetas…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Desplegando…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>Calcando %1…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>Hecho: %n sección.</numerusform>
            <numerusform>Hecho: %n secciones.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Selecciona primero la sección en la que cortar agujeros o coloca el dibujo sobre ella.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Selecciona primero la sección que se va a grabar o coloca el dibujo sobre ella.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Buscando planos…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>se lee cada vez</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>guardado en el modelo</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Buscar su archivo…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Leerla de donde está ahora su archivo; queda en su sitio</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Enlazar con su archivo…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>No guardarla en el archivo del modelo, que así ocupa menos, y leerla cada vez de donde está</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>Guardarla en el modelo</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>Incluirla en el archivo del modelo, para que esté también en otros ordenadores</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>Moverla, girarla y escalarla en la vista, con tiradores o números</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Con una línea</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Dibujar una línea sobre algo de ella cuya longitud conozcas</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Mover y girar</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Plantillas</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Añadir plantilla…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Leer una malla, una imagen o un dibujo para dibujar secciones a partir de él</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Añade una malla, una imagen o un dibujo, o bien arrástralo hasta aquí o pégalo. Las secciones que dibujas se ajustan a donde su plano corta una malla y a las líneas de un dibujo que esté en su plano.</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 renombra, Espacio oculta, L bloquea, Supr quita.</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Rebanadas…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>Cortarla en secciones que la siguen</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Lugar y tamaño</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Dimensiones</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Al suelo</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Apoyarla en el suelo</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Poner de pie</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Darle la vuelta: lo que en ella está arriba queda arriba en la vista</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>Falta %1</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloquear</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X de su centro</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y de su centro</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z de su centro</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Girada alrededor de X, primero</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Girada alrededor de Y, después de X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Girada alrededor de Z, al final</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Malla, %n triángulo</numerusform>
            <numerusform>Malla, %n triángulos</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Imagen, %1 × %2 píxeles</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Dibujo, %n línea</numerusform>
            <numerusform>Dibujo, %n líneas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Saltar este paso</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Recorrido, paso %1 de %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Mira alrededor.&lt;/b&gt; Arrastra junto al modelo para girarlo; con la rueda te acercas.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Córtalo.&lt;/b&gt; &lt;b&gt;Exportar…&lt;/b&gt; muestra las planchas y escribe el archivo para la cortadora.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Dibuja un cuerpo.&lt;/b&gt; Pulsa en el centro de la vista y dibuja su contorno de un solo trazo, plano por arriba, hasta el suelo.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Dibuja una sección que lo cruce.&lt;/b&gt; Pulsa dentro del cuerpo y arrastra hacia fuera por su borde. Mantén el botón pulsado: la vista gira. Dibuja entonces el contorno, otra vez hasta el suelo.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Mide tu plancha.&lt;/b&gt; Haz clic en el material, a la derecha de la barra de herramientas, luego en su grosor, y escribe lo que has medido: todas las ranuras lo siguen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;¿Funcionará?&lt;/b&gt; Te lo dicen las insignias sobre la vista. Haz clic en una para leer más.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Repítela.&lt;/b&gt; Elige &lt;b&gt;Fila&lt;/b&gt;, haz clic en la sección que cruza el cuerpo y después en el cuerpo: las copias se colocan en fila a lo largo.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Ese era todo el camino,&lt;/b&gt; del primer trazo al archivo. Lo que está en rojo tiene enlaces en Revisión que lo arreglan. Pulsa &lt;b&gt;F1&lt;/b&gt; para saber más.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Casi.&lt;/b&gt; Arrastra hacia atrás el tirador redondo al final de la fila hasta que ninguna insignia esté en rojo; entonces &lt;b&gt;Exportar…&lt;/b&gt; escribe el archivo para la cortadora.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;Ha quedado muy pequeño.&lt;/b&gt; Deshazlo y dibújalo más grande, más o menos la mitad de ancho que la vista.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;El recorrido termina aquí.&lt;/b&gt; Puedes repetirlo desde el menú &lt;b&gt;Ayuda&lt;/b&gt;. Pulsa &lt;b&gt;F1&lt;/b&gt; para saber más.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>No se puede respaldar el trabajo sin guardar por si hay un fallo. Guárdalo para estar a salvo.</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Este trabajo se abrió o se descartó en otra ventana.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>No se pudo abrir la copia de seguridad: %1.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sin título</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n paso</numerusform>
            <numerusform>%n pasos</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Una copia de trabajo sin guardar se hizo con un FlatFitFab más nuevo; se conserva como %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Una copia de trabajo sin guardar no se pudo leer; se conserva como %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Número entero</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Proporción</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Sí o no</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Opción</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>small</source>
        <translation>pequeño</translation>
    </message>
    <message>
        <source>large</source>
        <translation>grande</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Opciones</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>pequeño | grande</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Sale de</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>título encima</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>para qué es</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Esto no se puede leer como lo que se necesita aquí.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Los demás pueden adaptarlo</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Se puede cambiar cuando el diseño se comparte para adaptar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>Lo que sale de él se convierte en simples números</translation>
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
        <translation>Nombre del valor</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Tipo, intervalo y nota</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Solo para ti</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>Ahora es más estrecho el intervalo de: %1.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>Se ha probado %n variante y es buena.</numerusform>
            <numerusform>Se han probado %n variantes y todas son buenas.</numerusform>
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
            <numerusform>%1 de %n variante falla: %2.</numerusform>
            <numerusform>%1 de %n variantes fallan: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>De %1 extremos se probaron %2.</translation>
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
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Probando los intervalos… %1 %</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Probar otra vez</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Probar todos los intervalos</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Estrechar los intervalos</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Dice en qué puntos de los intervalos de los valores mostrados el modelo no se puede montar, se rompe, se cae o no cabe.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Valor nuevo</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>valor</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Este diseño está hecho para adaptarlo: cambia sus valores y después expórtalo. Arrastra en la vista para girarlo.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>Se corta de %1.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>En este diseño no hay nada que adaptar.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Editar el diseño</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Compartir para adaptar</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Recuperar el dibujo y todos los paneles; si se guarda ahora, el archivo se abre así.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Quien abra el modelo guardado verá la vista, los valores mostrados y Exportar, y nada más.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Ponle nombre a un número: cualquier campo puede usarlo, también en cuentas como = 2*hueco.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Cómo se muestra el modelo</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rayos X</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Haz clic para volver a ver las secciones como son.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Vista en corte</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Haz clic para volver a ver el modelo entero.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>ARRIBA</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>ABAJO</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>FRENTE</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>DETRÁS</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>DER.</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>IZQ.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>Vista del modelo</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Dibuja con el botón izquierdo del ratón y gira con el derecho.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 para el taller</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Los pasos no están entre los archivos: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Dónde poner la carpeta «%1»</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Ponerla aquí</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>en esta pantalla no se puede hacer ninguna imagen.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Dibuja piezas planas en 3D y las corta.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modelos para abrir, cada uno en una ventana; dibujos, mallas e imágenes para añadir a uno nuevo.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Abre FILE como copia: al guardar pide un nombre.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Reproduce un guion de pulsaciones y movimientos.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>GUION</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Arranca sin lo que se hubiera configurado y no guarda ninguna preferencia.</translation>
    </message>
</context>
</TS>
