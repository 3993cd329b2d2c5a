<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n peça</numerusform>
            <numerusform>%n peças juntas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (peça %2)</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (juntas desde o passo %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>mais %n</numerusform>
            <numerusform>mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>para cima</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>para baixo</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>para a direita</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>para a esquerda</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>para a frente</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>para trás</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>no sentido da seta</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Ainda não há nenhuma seção; por isso, não há passos.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>Nada é cortado deste modelo; por isso, não há passos.</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Não há passos para mostrar: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>Não há passos para mostrar: a ordem de montagem não foi encontrada a tempo.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>Não há passos para mostrar: o modelo não pode ser montado, pois %n seção está travada.</numerusform>
            <numerusform>Não há passos para mostrar: o modelo não pode ser montado, pois %n seções se travam umas às outras.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>Não há passos para mostrar: o modelo não pode ser montado, pois peças de %1 se travam umas às outras.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>Não há passos para mostrar: o modelo não pode ser montado, pois %1 se travam umas às outras.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Passo %1 de %2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>comece com %1</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>comece um grupo à parte com %1</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>ponha %1 no lugar</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>traga %1 contornando o canto e, por fim, %2</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>traga %1 contornando o canto e depois deslize %2 até encaixar em %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>mova %1 %2 até o lugar</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>deslize %1 %2 até encaixar em %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Aqui aguenta mais %1 até %2 trincar %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Aqui aguenta %1 até %2 trincar %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Aqui aguenta mais %1 até tombar.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Aqui aguenta %1 até tombar.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Aqui aguenta mais %1 até um encaixe se abrir.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Aqui aguenta %1 até um encaixe se abrir.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Aqui aguenta mais de %1.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>Não foi possível calcular quanto aguenta aqui.</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Alargar a base</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Adicionar um pé</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Conectado. Só uma seção até agora.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 encaixe</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n encaixe</numerusform>
            <numerusform>%n encaixes</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Conectado. As duas seções, por %1.</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Conectado. Todas as %1 seções, por %2.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Estaria conectado %1.</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 não está unida ao resto.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 não estão unidas ao resto.</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 encontra %2, mas nada as mantém unidas.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 encontram %2, mas nada as mantém unidas.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Nada toca %1. Ela está a %2 de %3.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Nada mais toca %1. Elas estão a %2 de %3.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Excluir todas</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Conectado</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Estaria conectado</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Não conectado</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Desenhe uma seção que cruze as duas ou mova uma delas até a outra.</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Ainda não conectado</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>se tudo ficasse unido</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>se nada se desmontasse</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>se a largura de corte não fechasse nenhuma fenda</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>se nenhuma fenda fosse apertada demais</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>se nenhuma fenda fosse larga demais</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>se não se dobrasse</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>se não escorregasse</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>se nada se soltasse</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>se nenhum encaixe se abrisse</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>se nada o empurrasse</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>Terminar uma na outra</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>Terminar %1 em %2</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>O encaixe delas está definido como “Nenhum”.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Nenhuma fenda permite que elas se encaixem: a folga negativa deixa a fenda sem largura. Aumente a folga.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Nenhuma fenda permite que elas se encaixem: em um ponto só poderiam deslizar para um lado; em outro, só para o lado oposto. Encurte uma delas.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Nada as seguraria: há furos onde as fendas começariam. Diminua os furos ou deixe uma delas terminar dentro da outra.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Nenhuma fenda permite que elas se encaixem: nenhuma das duas chega à borda. Abra um furo para fora ou deixe uma delas passar através da outra.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 e %2 se sobrepõem ao longo de %3. %4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>menos de %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 e %2 se sobrepõem %3, fora das fendas.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 e %2 se sobrepõem %3, mas não estão unidas.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 e %2 estão quase no mesmo plano: encontram-se a %3, e abaixo de %4 nenhuma fenda consegue segurá-las.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 e %2 se encontram a %3; abaixo de %4 as fendas ficam largas.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Mova uma delas para o lado ou deixe-a terminar antes da outra.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Seções se sobrepõem</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Ângulo muito fechado</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Gire uma delas para um ângulo mais aberto.</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Unir</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Unir a %1</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Unir todas a %1</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover até %1</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Mover todas até %1</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Aparar %1</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Unir com linguetas</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 não segura %2: a fenda corre ao longo da borda e só tem material de um lado.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 não segura %2: ali as fendas a cortam de fora a fora.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 não segura %2: a fenda tem menos de %3 de profundidade.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 não segura %2: a fenda não deixa material em nenhum dos lados.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 não segura %2: outras fendas tiram o que ficaria dentro da fenda.</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Afaste a fenda da borda.</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Deixe uma das seções que se cruzam ali terminar antes das outras ou mova-a para o lado.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>Fenda não segura nada</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>As fendas cortam %1 em %2 peças</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 sai em %2 peças</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nada segura uma delas, de %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nada as segura, sendo a maior de %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1; nada segura %2 delas, sendo a maior de %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>As fendas cortam %1 em pedaços. Nada segura o que foi cortado, que fica unido entre si.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>As fendas cortam %1 em pedaços. Nada segura o que foi cortado, junto com %2.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>As fendas cortam %1 em pedaços. Nada segura a peça de %2 com %3.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Inverter fendas</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Peças soltas</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Afastar %1 da borda</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover %1 para longe</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Deixar a fenda mais rasa</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>A fenda %1 fica fechada pela largura de corte de %2. Dê mais folga às fendas do material ou diminua a largura de corte.</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>A fenda %1 é mais estreita que a ferramenta de %2. Dê mais folga às fendas do material ou escolha uma ferramenta mais fina.</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Entre os ressaltos, as fendas são %1 mais estreitas do que aquilo que entra nelas. Isso é apertado demais para qualquer material: diminua os ressaltos.</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>As fendas são %1 mais estreitas do que aquilo que entra nelas. Isso é apertado demais para qualquer material.</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>As fendas são %1 mais largas do que aquilo que entra nelas; o encaixe fica frouxo.</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Ajustar a folga</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Fendas apertadas demais</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Fendas largas demais</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Fenda mais estreita que a ferramenta</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Tentar de novo</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Mostrar a cópia para relatar o erro</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Não calculado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Pode ser montado. Só uma peça até agora.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Pode ser montado. Mas nada segura uma das peças.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Pode ser montado. Mas nada segura %n das peças.</numerusform>
            <numerusform>Pode ser montado. Mas nada segura %n das peças.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Pode ser montado. %n passo.</numerusform>
            <numerusform>Pode ser montado. %n passos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Poderia ser montado %1.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Ainda não pode ser montado. Poderia ser se duas seções não se sobrepusessem.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Ainda não pode ser montado. Poderia ser se %n par de seções não se sobrepusesse.</numerusform>
            <numerusform>Ainda não pode ser montado. Poderia ser se %n pares de seções não se sobrepusessem.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Mostrar os passos</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>As seções se travam. %1 se encontram em %2 que deslizam em %3 direções diferentes.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>As seções se travam. %1 só sai %2 da fenda antes de bater em %3.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>As seções se travam. Nenhuma de %1 pode ser retirada em linha reta.</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Tornar montável</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>1 encaixe invertido.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>%n encaixe invertido.</numerusform>
            <numerusform>%n encaixes invertidos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Ordem não encontrada: %1.</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Ordem não encontrada. A busca demorou demais; isso não diz nada sobre o modelo.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Pode ser montado</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Poderia ser montado</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Ainda não pode ser montado</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>Não pode ser montado</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Encurte uma delas ou gire-a para que deslize na mesma direção que as outras.</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Ordem não encontrada</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Encaixe se abre. O encaixe de %1 e %2 é puxado com %3 N até se abrir.</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>Não sustenta nada. O encaixe de %1 e %2 é puxado com %3 N até se abrir; os outros aguentam sem ele.</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Preso por atrito. O encaixe de %1 e %2 é puxado com %3 N, o que só um ajuste apertado segura.</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Encaixe se abre</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>Não sustenta nada</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>Inverter as fendas</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Cole-o.</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Preso por atrito</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Tomba empurrado. Sem as forças, ficaria de pé.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Tomba empurrado</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Dê a ele uma base mais larga ou mais peso, ou empurre com menos força ou mais embaixo.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 estão unidas em anel: monte-as na ordem dos passos.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 estão unidas em anel: qualquer que seja a última, ela precisa deslizar em duas outras ao mesmo tempo.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Há seções unidas em %n anel: monte-as na ordem dos passos.</numerusform>
            <numerusform>Há seções unidas em %n anéis: monte-as na ordem dos passos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Há seções unidas em %n anel: qualquer que seja a última, ela precisa deslizar em duas outras ao mesmo tempo.</numerusform>
            <numerusform>Há seções unidas em %n anéis: qualquer que seja a última de cada anel, ela precisa deslizar em duas outras ao mesmo tempo.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>Unidas em anel</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Apoiar com um pé</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 chapa</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n chapa</numerusform>
            <numerusform>%n chapas</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Cabe na chapa. %1, %2 % de uso.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Cabe na chapa. %1 de %2, %3 % de uso.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%1 peças de %2 não cabem em nenhuma chapa de %3 com margem de %4, seja qual for a rotação.</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 mede %2 e não cabe em nenhuma chapa de %3 com margem de %4, seja qual for a rotação.</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Escolher uma chapa</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Cabe na chapa</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>Grande demais para a chapa</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Esticar todas até o chão</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Esticar %1 até o chão</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Pousar no chão</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Levantar até o chão</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Fica de pé, mas balança %1. Só tomba além de %2. Margem de %3.</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Fica de pé. Só tomba além de %1. Margem de %2.</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Fica de pé, inclinado %1. Só tomba além de %2. Margem de %3.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>O ponto mais baixo de %1 fica %2 acima do chão.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>Os pontos mais baixos de %1 ficam até %2 acima do chão.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Inclina-se %1 para a frente</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Inclina-se %1 para trás</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Inclina-se %1 para a esquerda dele</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Inclina-se %1 para a direita dele</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Balança %1: os pontos mais baixos não estão todos no chão. Só tomba além de %2.</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1 antes de ficar de pé: os pontos mais baixos não estão todos no chão. Só tomba além de %2.</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Ficaria de pé %1. Só tombaria além de %2. Margem de %3.</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Tomba com um toque: inclinado %1, já tomba. Margem de %2.</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Mal fica de pé: inclinado %1, já tomba. Margem de %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Balança</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Inclina-se</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Tomba com um toque</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Tomba fácil</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Tomba para a frente. O centro de massa fica %1 à frente dos pés.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Tomba para trás. O centro de massa fica %1 atrás dos pés.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Tomba para a esquerda dele. O centro de massa fica %1 fora dos pés.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Tomba para a direita dele. O centro de massa fica %1 fora dos pés.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Tomba. Todos os pés estão em uma só linha e nada o mantém de pé.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>Não está no chão. O ponto mais baixo delas fica %1 acima dele.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>Não está no chão. O ponto mais baixo fica %1 acima dele.</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Dê a ele mais um pé ou mova peso para cima dos pés.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Una-o ao que fica de pé ou mova-o até o chão.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Ainda não fica de pé</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Ainda não está no chão</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Fica de pé</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Ficaria de pé</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Faça todos os pés terminarem na mesma altura.</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Tomba</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>Não está no chão</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 vezes isso</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>a carga</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Resistente</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Aguenta %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Seria resistente</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Aguentaria %1</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Pode trincar</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Resiste por pouco</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Pode trincar com %1</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Mal aguenta %1</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Vai quebrar</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Fraco demais</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Quebra com %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Fraco demais para %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 quebra %2 a partir de %3.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 pode trincar %2 a partir de %3;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>o trecho estreito quebra com %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>o trecho estreito de %1 quebra com %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 pode trincar %2 a partir de %3.</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Com %1, um encaixe se abre.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Com %1, não fica mais de pé.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Aguentaria muito mais.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>Não foi possível calcular quanto aguentaria.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>Não sofre nenhum esforço.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>O ponto mais fraco é %1, %2: menos de 1 % da resistência.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>O ponto mais fraco é %1, %2: %3 % da resistência.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Flexiona %1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>O trecho estreito de %1 está a %2 % da resistência.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>Isso deixa menos que o fator de segurança de %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Resistência desconhecida. O material de %1 não tem resistência definida.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Resistência desconhecida. As forças entre as seções não puderam ser calculadas.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Resistência desconhecida. A tensão em %1 não pôde ser calculada.</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Escorrega. Os pés não o seguram contra o que o empurra: empurre com menos força ou dê a ele mais peso.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Solta-se. Nada mantém %1 no lugar: cole os encaixes ou adicione mais um.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Dobra-se. Os dedos giram como dobradiças e nada mais impede %1 de girar: cole-os ou una-os a mais uma seção.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Fora do material. Um peso em %1 não está sobre o material; o ponto mais próximo o recebe.</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Use material mais grosso, alargue ali ou ponha menos peso.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistência desconhecida</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Solta-se</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Dobra-se</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Fora do material</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Usar material de %1 de espessura</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Usar material mais grosso</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Informar a resistência</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Desmonta-se. %1 está ligada por menos do que se consegue cortar.</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Pouco material. %1 tem só %2 de largura em um ponto.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Desmonta-se</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Alargue ali ou afaste o que se toca.</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Pouco material</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Alargue-a ali.</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: as fendas para %2 se atravessam.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: não resta nada entre as fendas para %2.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: não resta nada entre a fenda para %2 e um furo.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: não resta nada entre a fenda para %2 e a borda.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: restam só %2 de material entre as fendas para %3.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: restam só %2 de material entre a fenda para %3 e um furo.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: restam só %2 de material entre a fenda para %3 e a borda.</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Um tanto fino</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Alargue a seção ali ou mova a fenda.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Fendas se atravessam</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Massa de %1. O centro de massa fica %2 acima do chão.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 e %2 só se tocam: sobrepõem-se menos de %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n par de seções só se toca: sobrepõe-se menos de %1.</numerusform>
            <numerusform>%n pares de seções só se tocam: sobrepõem-se menos de %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Só se tocam</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar %1 para 90°</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>As fendas cortam de %1 uma lasca de menos de 1 mm². Ela é sobra e não recebe número.</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>As fendas cortam de %1 %n lasca de menos de 1 mm². Ela é sobra e não recebe número.</numerusform>
            <numerusform>As fendas cortam de %1 %n lascas de menos de 1 mm². Elas são sobra e não recebem número.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Sobra</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>As fendas de %1 a dividem em %2, que outras seções mantêm unidas.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n peça</numerusform>
            <numerusform>%n peças</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>As fendas de %1 não deixam sobrar nada.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>Não foi possível recortar %1: o que as fendas deixam dela não pôde ser calculado. Nada pode ser exportado; a massa é contada sem as fendas.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 não pôde ser calculada: faltam seções dela. Nada pode ser exportado.</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Dividida por fendas</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>Não sobra nada</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Não recortada</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>Falha na operação</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Alargar ali</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n seção movida</numerusform>
            <numerusform>%n seções movidas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n seção movida %1 para baixo</numerusform>
            <numerusform>%n seções movidas %1 para baixo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>%n seção movida %1 para cima</numerusform>
            <numerusform>%n seções movidas %1 para cima</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>1 encaixe invertido</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>%n encaixe invertido</numerusform>
            <numerusform>%n encaixes invertidos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 passa a ter %2 de espessura</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>As fendas de 1 encaixe se encontram em outro ponto</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>As fendas de %n encaixe se encontram em outro ponto</numerusform>
            <numerusform>As fendas de %n encaixes se encontram em outro ponto</numerusform>
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
            <numerusform>%n seção girada</numerusform>
            <numerusform>%n seções giradas</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>um novo encaixe com uma fenda de %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 novo encaixe</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n novo encaixe</numerusform>
            <numerusform>%n novos encaixes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 com outra forma</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>%n seção com outra forma</numerusform>
            <numerusform>%n seções com outra forma</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 adicionada</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n seção adicionada</numerusform>
            <numerusform>%n seções adicionadas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 excluída</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n seção excluída</numerusform>
            <numerusform>%n seções excluídas</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>nada mais é cortado ao meio</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>1 problema resolvido</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n problema resolvido</numerusform>
            <numerusform>%n problemas resolvidos</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>depois: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>novo: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n novo aviso</numerusform>
            <numerusform>%n novos avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>ao lado da fenda para %1</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>onde se une a %1</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>em um canto interno</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>no trecho estreito</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>Unidas em anéis</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>Dentro do chão. %1 passa %2 abaixo dele.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>Dentro do chão. %1 passam até %2 abaixo dele.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>Dentro do chão</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Deslocar os planos em %1 %</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>Mais um plano em cada direção</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Cabe nas chapas e nos retalhos que há.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>No máximo %n chapa</numerusform>
            <numerusform>No máximo %n chapas</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Cabe na chapa. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Cabe na chapa. %1 de %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Seções se sobrepõem um pouco</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>Podem faltar chapas. É preciso até %n chapa de %1, e há %2.</numerusform>
            <numerusform>Podem faltar chapas. São precisas até %n chapas de %1, e há %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>Podem faltar chapas</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Veja em Chapas o quanto as peças podem ficar juntas.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Planos a cada %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, deslocado em %2 %</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>Mais um plano</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>Menos um plano em cada direção</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>Menos um plano</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>Mais dois planos em cada direção</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>Mais dois planos</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>Menos dois planos em cada direção</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>Menos dois planos</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Nenhum dos deslocamentos e números de planos testados permite que elas deslizem juntas. Converta as fatias e encurte uma delas, ou deixe-a de fora.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>O modelo está aqui para ser ajustado; “Editar o projeto” traz tudo de volta</translation>
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
        <translation>Abrir um modelo, também do FlatFab</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>Inserir modelo…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Inserir</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>Adicionar a este modelo as seções de outro</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>Referência para desenhar por cima…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Referência</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Ler uma malha, uma imagem ou um desenho para desenhar seções por cima</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>Adicionar à biblioteca</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>À biblioteca</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>Guardar a seleção na biblioteca, para outros modelos</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Salvar o modelo</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salvar como…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Salvar como</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Salvar o modelo com outro nome</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Exportar arquivos de corte…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>Salvar as peças em um arquivo para a cortadora a laser</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exportar de novo</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Exportar de novo</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Salvar de novo o mesmo arquivo, com as mesmas escolhas</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Reverter à versão salva</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Reverter</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Voltar ao modelo como está no arquivo; Desfazer traz as alterações de volta</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Configurações…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Configurações</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Unidades, cores, idioma, arquivos e atalhos</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Atalhos do teclado…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atalhos</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Ver que teclas fazem o quê e escolher as suas</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Fechar janela</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Fechar esta janela; as outras continuam abertas</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sair</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Sair</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Fechar todas as janelas e o programa</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Ir para Propriedades</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriedades</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Ir para o primeiro campo da seleção; na vista, Enter faz o mesmo</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Ocultar todos os painéis</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Ocultar painéis</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>Ocultar ou mostrar os painéis laterais</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Tela cheia</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Tela cheia</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Preencher a tela com a janela</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Restaurar janela</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Restaurar janela</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Pôr todos os painéis de volta no lugar original</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Próxima parte da janela</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Próxima parte</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Ir para a próxima parte da janela: barra de ferramentas, esquerda, vista, direita</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Parte anterior da janela</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Parte anterior</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Voltar à parte da janela antes desta</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>Próximo problema</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Próximo problema</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>Selecionar as seções do próximo problema e mostrá-las</translation>
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
        <translation>Selecionar as seções do problema antes deste</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Mostrar os passos</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Passos</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Mostrar passo a passo como o modelo é montado</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Materiais…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Materiais</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Materiais em chapa: espessura, resistência, largura de corte e tamanho da chapa</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Peça de teste…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Peça de teste</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Salvar uma peça de teste que mostra quais fendas servem e quanto a máquina corta de largura</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>Chapas</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Chapas</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>Mostrar as peças nas chapas, como serão cortadas</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Ir para os valores</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>Ajustar os valores que definem números do modelo</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Novo valor</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Um número com nome, que os campos de números aceitam</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Buscar comando…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Digite para encontrar tudo o que o programa faz</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>Primeiros passos</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primeiros passos</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Como se faz um modelo, passo a passo, com imagens</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Página inicial</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Página inicial</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Modelos recentes e exemplos</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>Sobre o FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Sobre</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>O que é este programa, sua versão e suas licenças</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Ainda não foi exportado</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Nunca foi salvo</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Nada mudou desde que foi salvo</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Mapa de resistência</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Mapa de resistência</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Colorir uma seção conforme a massa que cada ponto dela aguenta</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Selecione primeiro a seção a examinar</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Selecione primeiro uma seção</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>Nenhum encaixe selecionado: selecione uma seção e depois um de seus encaixes</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>Não há outra seção</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>Nenhuma operação selecionada</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Ainda não há nenhuma seção</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>Nenhuma seção selecionada</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Recortar</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Recortar</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>Copiar as seções selecionadas e excluí-las</translation>
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
        <translation>Copiar as seções selecionadas, também para outras janelas e programas</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Colar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Colar</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>Adicionar as seções copiadas, ou uma imagem para desenhar por cima</translation>
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
        <translation>Pôr uma cópia das seções selecionadas ao lado delas</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>Em X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>Espelhar X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Pôr uma imagem espelhada das seções selecionadas do outro lado do plano em que X é 0</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>Em Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Espelhar Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Pôr uma imagem espelhada das seções selecionadas do outro lado do plano em que Y é 0</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>Em Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Espelhar Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Pôr uma imagem espelhada das seções selecionadas do outro lado do plano em que Z é 0</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>Em uma seção…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Espelho</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Clique em uma seção: uma imagem espelhada das selecionadas surge do outro lado dela</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Seções de SVG…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>De SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Uma seção para cada contorno de um desenho</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>Contorno de SVG…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Contorno de SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>O maior contorno de um desenho no lugar do contorno da seção selecionada</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>Furos de SVG…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Furos de SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Um furo na seção selecionada para cada contorno de um desenho</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>Marcas de SVG…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Marcas de SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>As linhas de um desenho, gravadas ou vincadas na seção selecionada</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Desenhar forma</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Arrastar um círculo, retângulo ou outra forma a partir do centro</translation>
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
        <translation>Por números: um furo na seção selecionada ou uma seção própria</translation>
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
        <translation>Retângulo</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Retângulo</translation>
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
        <translation>Estrela</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrela</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>Oblongo</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Oblongo</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Mover referência</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Alças</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Mover, girar e redimensionar a referência com alças ou números</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Dimensionar referência por uma linha</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Por uma linha</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Traçar uma linha sobre a referência e dizer quanto ela mede</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>Não há imagem nem desenho: adicione um primeiro</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>Não há referência: adicione primeiro uma malha ou uma imagem</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Inverter as fendas do encaixe</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Inverter fendas</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>Fazer as fendas do encaixe selecionado abrirem para o outro lado</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Restaurar ajustes automáticos</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Deixar o programa escolher de novo o tipo, a direção e os pontos de encontro do encaixe selecionado</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>Nada neste encaixe foi definido à mão</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>Adicionar peso</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Pôr um peso em uma seção para ver quanto ela aguenta</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>Adicionar força</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Força</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>Empurrar ou puxar uma seção em um ponto para ver quanto ela aguenta</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>Puxar aqui</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Puxar</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Puxar uma seção com o mouse para ver o que acontece; nada fica</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Nada age sobre o modelo: adicione primeiro um peso ou uma força</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>Não há malha que possa ser atraída</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Adicionar texto ou linhas para gravar</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Gravar</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Escrever ou desenhar em uma seção, para gravar ou vincar</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>Gravar</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>O que for desenhado a seguir será gravado</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>Vincar</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Vincar</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>O que for desenhado a seguir será vincado, para dobrar ou quebrar ali</translation>
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
        <translation>Medir entre dois pontos; manter a medida ou redimensionar o modelo por ela</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Redimensionar por medida</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Redimensionar por medida</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Definir um comprimento e redimensionar o modelo de acordo</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Manter a medida</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Continuar mostrando esta medida</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Remover esta cota</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Remover esta cota</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>Nada foi medido</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>Nenhuma cota escolhida: clique em uma com Medir</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>Espelhar…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>Espelhar as seções selecionadas ou um lado do modelo para o outro</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Espelhar esquerda e direita (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>Espelhar no plano em que X é 0</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Espelhar em cima e embaixo (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Espelhar no plano em que Y é 0</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Espelhar frente e trás (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Espelhar no plano em que Z é 0</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>Espelhar em uma seção</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Seção</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>Espelhar no plano da seção clicada</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Espelhar uma cópia da seleção</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Adicionar uma imagem espelhada das seções selecionadas</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Manter os dois lados iguais</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Dois lados</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Espelhar tudo o que é desenhado de um lado, agora e depois</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Tornar simétrico uma vez</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Uma vez</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>Copiar um lado para o outro; edições posteriores não são copiadas</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Espelhar como mostrado</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Fazer o que é mostrado</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Escolha primeiro Espelhar</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>Aceitar forma sugerida</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Forma sugerida</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Transformar o que acabou de ser desenhado no círculo, na elipse, nas linhas retas ou nos ângulos retos sugeridos, ou afastar sua fenda da borda</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>Usar a guia inteira</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Usar a guia</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>Fazer a seção com tudo o que o plano dela corta de uma referência, com os furos</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>Nada é sugerido para o que acabou de ser desenhado</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>O plano em que se desenha não corta nenhuma referência</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>Fileira</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Fileira</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>Repetir uma seção em fileira ao longo de outra</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>Revolução pelo contorno</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Revolução</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Repetir uma seção ao redor do contorno de outra</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Transição</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transição</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Interpolar entre seções</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>Ramificação</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramificação</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Fazer cópias de uma seção crescerem dela mesma, como uma árvore</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Grade com conectores</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grade</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Dividir uma seção grande demais para a chapa</translation>
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
        <translation>Transformar uma seção em círculo, estrela ou engrenagem, ou abrir nela furos assim</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>Espelhar modelo</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Repetir de um lado tudo o que é desenhado do outro</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Simetria rotacional</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotacional</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Repetir ao redor de um eixo tudo o que é desenhado uma vez</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>Repetir seções ao longo de uma linha no espaço</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>Fatias de uma malha</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Fatias</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Cortar uma malha de referência em seções que a acompanham</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>Tornar simétrico agora</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simétrico</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>Espelhar um lado para o outro, uma vez</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>Desligar ou ligar</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ligada</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>Desligar a operação selecionada ou ligá-la de novo</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>Antes na ordem</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>Executar a operação selecionada antes da que está acima dela</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>Depois na ordem</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Depois</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>Executar a operação selecionada depois da que está abaixo dela</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>Converter em seções</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Converter</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Transformar em seções desenhadas o que a operação selecionada produz</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>Não há malha para fatiar: adicione uma primeiro</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>Já é a primeira</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>Já é a última</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Aderir</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Aderir</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>Aderir a pontos, linhas de alinhamento e grade</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Caneta</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Caneta</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Desenhar com cliques em vez de um só traço: marque pontos, arraste para curvar</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>Nenhum número foi digitado</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Remover furos</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Sem furos</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Fechar todos os furos das seções selecionadas</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Adicionar ponto</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Adicionar ponto</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Adicionar um ponto de controle sob o cursor ou ao lado do selecionado</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Excluir ponto</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Excluir ponto</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>Excluir os pontos de controle selecionados</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Ponto suave</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>Deixar o contorno suave nos pontos selecionados</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>Ponto simétrico</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>Deixar o contorno suave, com alças do mesmo comprimento dos dois lados</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Ponto de canto</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Canto</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Transformar os pontos selecionados em cantos</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>Nenhum ponto de contorno selecionado</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Selecione uma seção cujo contorno possa ser editado</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>A seleção não tem furos</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Mover e girar</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Mover, girar e redimensionar com alças ou números</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>Nos eixos do mundo</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Eixos do mundo</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Mover pelos eixos do mundo, e não no plano da seção</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Mover as seções presas</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Mover presas</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Seções que foram desenhadas nesta se movem junto com ela</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Pôr em outra seção…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Pôr em</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Clique na seção em que a selecionada deve ficar</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Soltar da seção-mãe</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Soltar da seção-mãe: não se move mais com ela nem mantém o ângulo</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Tornar perpendicular</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Perpendicular</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>Girar a seção até ficar perpendicular àquela em que está</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>Alinhar ao eixo mais próximo</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Alinhar</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>Girar a seção até ficar voltada para um eixo do mundo</translation>
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
        <translation>Proteger as seções selecionadas contra alterações</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>Editar a origem</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Editar origem</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>Selecionar a seção da qual a selecionada é feita</translation>
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
        <translation>Transformar a seção selecionada em uma desenhada; a operação continua a fazer as outras</translation>
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
        <translation>Omitir a seção selecionada; a operação continua a fazer as outras</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>A seleção não está em outra seção</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>A seleção é feita por uma operação</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>A seleção não é simétrica</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>A seleção foi desenhada, não é feita por uma operação</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Selecionar tudo</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Selecionar tudo</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Selecionar todas as seções</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Selecionar próxima</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Próxima</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>Selecionar a próxima seção</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Selecionar anterior</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>Selecionar a seção antes desta</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>Selecionar conectadas</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Conectadas</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Selecionar todas as seções conectadas às selecionadas</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>Selecionar paralelas</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Paralelas</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Selecionar todas as seções paralelas às selecionadas</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Selecionar mesmo material</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Mesmo material</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Selecionar todas as seções do mesmo material que as selecionadas</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Novo</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Novo</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Começar um novo modelo</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Desfazer o último passo</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Refazer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Refazer</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>Refazer o passo que foi desfeito</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>Excluir as seções selecionadas</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Marcar um ponto</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nada para desfazer</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Desfazer “%1”</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nada para refazer</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Refazer “%1”</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Desafixar todas as peças</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Desafixar todas</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Permitir de novo que todas as peças sejam movidas ao serem dispostas nas chapas</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>Nenhuma peça está fixada na chapa</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>Pele</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Pele</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>Mostrar a forma que as seções sugerem, como uma superfície sobre elas</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Simetria local</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetria</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Espelhar um contorno em relação à fenda quando for desenhado de um só lado dela</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Cortar rente ao chão</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Chão</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Cortar o que for desenhado abaixo do chão</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>No chão</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>No chão</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Desenhar uma seção deitada no chão</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>No plano frontal</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>Frontal</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Desenhar uma seção em pé no meio, vista de frente</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>No plano lateral</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Lateral</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Desenhar uma seção em pé no meio, vista de lado</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>Paralela à seção</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Desenhar uma seção paralela à selecionada</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Redesenhar contorno</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Redesenhar</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Desenhar um novo contorno para a seção selecionada</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>Desenhar um furo</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Furo</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>Desenhar um furo na seção selecionada</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Pousar no chão</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Pousar</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Pousar o modelo no chão</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>O modelo já está no chão</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Entregar para ajustes</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Entregar</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Quem abrir o modelo salvo verá a vista, os valores mostrados e Exportar, e nada mais</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Editar o projeto</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Ainda não há valor que outros possam ajustar</translation>
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
        <translation>Ver de frente</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Topo</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Topo</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Ver de cima</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Ver da direita</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Trás</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Trás</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Ver de trás</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Ver de baixo</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Ver da esquerda</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Próximo canto</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Ver do próximo canto</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Ver a seção de frente</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>De frente</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Olhar de frente para a seção selecionada</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Enquadrar tudo</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Enquadrar</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Mostrar o modelo inteiro</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Enquadrar seleção</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Enquadrar seleção</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>Mostrar as seções selecionadas o maior possível</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Vista anterior</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Voltar à vista antes desta</translation>
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
        <translation>Mostrar menor o que está mais longe, como o olho vê</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Raio X</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Raio X</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Ver através de todas as seções, até as fendas</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Só a seleção</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolar</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Esmaecer todas as outras seções</translation>
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
        <translation>Ocultar as seções selecionadas</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostrar tudo</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar tudo</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>Mostrar de novo as seções ocultas</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Abrir a vista em corte</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Em corte</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Cortar o modelo com um plano, para olhar por dentro</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>Chão e sombra</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>Mostrar o chão com sua grade e a sombra do modelo</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Linhas de tensão</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Tensão</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Mostrar onde o modelo sofre mais esforço</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>Nenhuma seção está oculta</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>Não há vista antes desta</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>A janela simples não tem isto; nas Configurações está a completa</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Primeiro modelo em 3 minutos</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Desenhar, verificar e cortar um modelo passo a passo, em uma janela vazia</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Ajuda sobre o que está sob o cursor</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Abre a ajuda onde ela fala desta parte da janela</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>Não espelhar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Deixar tudo como estava</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Escreve JSON, para outros programas.</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Seções, encaixes, tamanho e massa de um modelo</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Se ele se mantém unido, fica de pé, pode ser montado e cabe na chapa</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Se ele é resistente: forças, tensão e quanto aguenta</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>As peças a cortar, nas coordenadas de cada seção</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Uma imagem do modelo; precisa de tela</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Como ele é montado, passo a passo; precisa de tela</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>Os valores com nome de um modelo e o que é feito deles</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Um arquivo de corte e um veredito para cada linha de uma tabela de valores</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Todos os tipos de operação, ou as operações de um modelo</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>Os contornos em que um plano corta uma malha</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Seções que mostram uma malha, ficam de pé e podem ser montadas</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Um modelo de uma malha em fatias</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Um modelo de chapas planas com dedos ao longo das bordas</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Peças bem juntas em chapas, ou os itens de uma tira (.json)</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Executa um roteiro do que uma pessoa faz na janela</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Cortadas por completo pelas fendas, portanto sem peça: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>Grandes demais para a chapa, em chapas próprias: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Estreitas demais para levar um número: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Um furo ou um recorte mais estreito que a largura de corte não é cortado: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>Sem espaço para os números de todos os encaixes: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>Não foi possível escrever na saída padrão.</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>Nada a verificar: o modelo não tem seções.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>As seções flexionam onde encaixes dividem uma carga, por elementos finitos; leva segundos.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>A carga fica por meses: cada material conserva só a sua fração da resistência para isso.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>Não existe “%1”.</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF com camadas por finalidade</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Versão de um arquivo DXF: r2000 ou r12 (r2000).</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>o próprio modelo</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Milímetros por unidade de um arquivo do FlatFab (25.4).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-code para lasers</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>um projeto do LightBurn</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>os sólidos no lugar</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>a lista de peças</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF em tamanho real</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Páginas de um arquivo PDF: sheet (uma por chapa), ou dividido em folhas a4 ou letter (sheet).</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>uma imagem das chapas</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Como as peças ficam em um arquivo STL ou 3MF: in-place (no lugar), ou flat (deitadas nas chapas) (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>as peças para imprimir</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>arquivos de corte, em tamanho real</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>tudo para uma oficina</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>não há tela com OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>A busca foi interrompida antes do fim porque este computador está ocupado: outra execução pode dar outra disposição.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Fendas para testar</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Tira para encaixar</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Ripa para medir</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Perto demais da borda: a fenda não seguraria nada</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Perto demais da borda: a fenda não seguraria nada. B: afastar da borda</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Afastada %1 da borda. B: voltar atrás</translation>
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
        <translation>perpendicular à borda</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>paralela à última</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Girando…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Desenhe o contorno</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Ainda não unida</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>“%1” é %2, o que não é possível aqui.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>“%1” e outra expressão querem que isto seja diferente ao mesmo tempo.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Aquilo a que este número pertence não existe mais.</translation>
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
        <translation>Ângulo</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>X do centro</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>Y do centro</translation>
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
        <translation>Altura das letras</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Folga</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Largura de corte</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Largura da chapa</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Altura da chapa</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Diâmetro da ferramenta</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Chanfro de entrada das fendas</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Ressaltos nas fendas</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Cheio de</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Força em X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Força em Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Força transversal</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Ponto de encontro</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>“%1” não é possível aqui: números que seguem valores mantêm isso em %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>“%1” não é possível aqui: %2 segue “%3”, que mantém tudo como está.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>“%1” não pode ser calculado.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>“%1” está vazio, e isso não é possível aqui.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>não há memória suficiente</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>uma malha: isto é plano</translation>
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
        <translation>o índice do conteúdo está danificado</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>esta entrada está danificada</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>esta entrada está criptografada</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>há mais neste arquivo do que o seu conteúdo</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>esta entrada aparece duas vezes</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>esta entrada está compactada de um modo desconhecido</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>esta entrada tem um nome diferente do que está no índice do conteúdo</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>entradas dele compartilham os mesmos bytes</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>esta entrada fica grande demais ao ser descompactada</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>dados gzip sem danos</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>o resto dos dados gzip</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>uma chapa maior</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>um arquivo precisa de um nome</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>este arquivo é somente leitura</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>esta pasta é somente leitura</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>um modelo</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>este valor não é permitido aqui</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>não foi encontrado nada; esperado: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>encontrado: “%1”; esperado: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>esta quantidade não é possível</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>encontrada a quantidade %1; esperado: no máximo %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>encontrado: %1 %3; esperado: no máximo %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>feito com um FlatFitFab mais novo</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>feito com um FlatFitFab mais novo: encontrado o formato %1; esperado: no máximo %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>estes pontos de controle não formam um contorno fechado</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>estes pontos de controle não formam um contorno fechado: encontrado: %1; esperado: %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>nenhum caminho consegue acompanhar todo este contorno à metade da largura de corte</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>nenhum caminho consegue acompanhar todo o contorno de %1 à metade da largura de corte de %2 mm; suavize os detalhes mais finos do contorno ou dê ao material outra largura de corte</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>a largura de corte fecha uma fenda</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 tem uma fenda de %2 mm de largura, que uma largura de corte de %3 mm fecharia</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>um arquivo %1</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>um arquivo %1 do %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>não foi possível abrir</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>não foi possível escrever</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>não é um modelo; esperado: %1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>o arquivo termina aqui; esperado: %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>o arquivo termina antes da hora</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>encontrado: “%1”; esperado: um número finito</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>um número não é finito</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>estes eixos não formam um sistema de coordenadas; esperado: dois de comprimento 1 em ângulo reto</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>este contorno não cerca nenhuma área</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>não há nada com o número %1</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>isto aponta para algo que não existe</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>o número %1 é usado duas vezes; esperado: um número próprio</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>este número é usado duas vezes; esperado: um número próprio</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>estas duas seções são quase paralelas e não podem ser unidas</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>este contorno se cruza</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>um furo tocaria a borda ou outro furo</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>sobrariam pontos de menos para cercar alguma coisa</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>as fendas não deixam nada de nenhuma seção, portanto não há nada para cortar</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>ainda não há nenhuma seção, portanto não há nada para cortar</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>nenhum dos vãos entre os contornos pode ser coberto (%1), portanto não há pele</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>nenhum contorno cruza outro na borda, portanto não há pele</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>não existe o comando “%1”</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>esse comando não existe</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>este evento não faz sentido aqui</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>“%1” não é aceito por esta versão</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>isto não é aceito por esta versão</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>isto não pôde ser calculado</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>não foi possível recortar “%1”: o que as fendas deixam dela não pôde ser calculado</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>não foi possível recortar uma seção</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>o sólido de “%1” não pôde ser calculado</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>um sólido não pôde ser calculado</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>as marcas em “%1” não puderam ser aparadas na borda</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>as marcas em uma seção não puderam ser aparadas na borda</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>as seções da operação “%1” não puderam ser calculadas</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>as seções de uma operação não puderam ser calculadas</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>algo deu errado dentro do FlatFitFab (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>algo deu errado dentro do FlatFitFab</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>foi interrompido</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>o conteúdo deste arquivo está danificado</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 estava um pouco torta e foi endireitada</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>uma seção estava um pouco torta e foi endireitada</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>o contorno de %1 se cruza; ficou o laço maior</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>um contorno se cruza; ficou o laço maior</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>um furo de %1 passa do contorno e foi omitido</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>um furo passa do contorno e foi omitido</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>um furo de %1 não tem área e foi omitido</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>um furo não tem área e foi omitido</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>furos de %1 se sobrepõem e foram juntados em um só</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>furos se sobrepõem e foram juntados em um só</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>um furo de %1 passa do contorno e foi recortado dele</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>um furo passa do contorno e foi recortado dele</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>as linhas depois da última seção foram ignoradas</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>o texto depois da última seção foi ignorado, linhas: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 não pôde ser lida e foi omitida</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>uma imagem ou uma malha foi omitida</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 foi omitida: %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>o que %1 mostra não pôde ser lido; o lugar dela foi mantido</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>uma referência não pôde ser lida; o lugar dela foi mantido</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved ou scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>três pontos de controle por segmento e mais um</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>pelo menos uma linha</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>dois lugares diferentes</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>uma palavra de letras e algarismos, uma vez</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>faltam os dados</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>um SHA-256 em 64 algarismos hexadecimais</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>uma entrada com este nome não pertence aqui</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>os dados desta entrada não correspondem ao nome dela, um SHA-256</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>falta esta entrada</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>nada no documento aponta para esta entrada</translation>
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
        <translation>uma largura de 1 a 10000 mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>uma força [x, y, z] acima de 0, no máximo 1000000 N</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>uma altura de 0 a 10000 mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>uma parte da sua massa</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden ou detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>algo diferente de made, cada instância uma vez</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>um id abaixo de nextId</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>uma fração acima de 0, no máximo 1</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>mais do que a espessura negativa</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>uma largura e uma altura acima de 0</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone ou tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>três pontos de controle por segmento, pelo menos 6</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom ou top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>uma direção de comprimento 1</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs ou none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>uma fração de 0.05 a 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>algo pedido de duas seções, pares em ordem crescente</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>uma seção-mãe que não descenda da própria filha</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>pelo menos um material</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>cada peça uma vez, na ordem das seções</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>cada seção uma vez, na ordem delas</translation>
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
        <translation>nada: só malhas são atraídas</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>um raio de 0.1 a 1000 mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>o caminho de um arquivo</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>o SHA-256 de um blob, ou um arquivo</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>nada: uma malha não fica em nenhuma seção</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>uma escala de 1e-9 a 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>uma opacidade de 0 a 1</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals ou groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>uma expressão que não seja tão longa</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice ou switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>um nome sem “=”, cada um só uma vez</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>cada valor uma vez</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>uma palavra de letras e algarismos, cada uma só uma vez</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>cada número uma vez</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>um comprimento de no máximo 1000000 mm</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>um último ponto de controle que repita o primeiro</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>um número</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>uma quantidade</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>um ponto de dois números</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>três pontos de controle por segmento e o primeiro de novo, pelo menos 7</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>pelo menos 1 curva</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>um buffer com bytes</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>um buffer no arquivo</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>um comprimento que o buffer tenha</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>um tipo de número que exista em glTF</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>tantos valores quantos o buffer tem</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>tantos números quantos cabem ali</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>um nó que não esteja dentro de si mesmo</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>um bloco de um arquivo GLB</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>a versão 2 de GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>um arquivo glTF</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>a versão 2 de glTF</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>um objeto</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>uma lista</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>um número acima de 0, no máximo 1000000</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>um número de 0 a 1000000</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>um número inteiro dentro do seu intervalo</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>um texto</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>um ponto [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>um ponto [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>uma lista de pontos</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>um nome entre aspas ou o fim do objeto</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>dois-pontos</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>uma vírgula ou o fim da lista</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>uma sequência de escape de JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>texto em UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>o fim do texto entre aspas</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>outro valor depois da vírgula</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>no máximo 1024 níveis</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>um arquivo menor</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>o fim do arquivo</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>um valor</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>cada chave de um objeto só uma vez</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>as duas metades de um caractere</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>uma cor como #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>uma largura de linha em mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>uma velocidade em mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>uma linha de G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>linhas de G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>o maior S</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>largura e altura em mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>uma fração de 0 a 1</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>uma largura de pontes em mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>um comprimento de entradas em mm</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>máquinas</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>uma máquina</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triângulos</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>vértices</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>está em outra pasta</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>uma malha</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>um número inteiro</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>pelo menos três pontos</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon ou polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>pelo menos um ângulo</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>um problema de disposição em tira</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>pelo menos um item</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>pelo menos três cantos de uma face</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>o número de vértices</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>o número de faces</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>os cantos de uma face</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>a imagem está danificada</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>o resto da imagem</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>a imagem está danificada aqui</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>uma imagem em PNG, JPEG ou WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>uma imagem com pelo menos um pixel</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>nada escreve neste pipe</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>não saiu nada dele por 10 segundos</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>nada lê deste pipe</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>o formato</translation>
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
        <translation>um tipo como float ou int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>primeiro um elemento</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>tantos valores quantos o arquivo diz que tem</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y e z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>o comprimento de uma lista</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>o disco está cheio</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>o número de triângulos</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>tantos triângulos quantos o arquivo diz que tem</translation>
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
        <translation>três cantos de um triângulo</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>linhas; o texto precisa antes ser convertido em caminhos</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>linhas; uma imagem precisa antes ser traçada</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>linhas, formas ou caminhos</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>uma transformação</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>grupos dentro de grupos</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>lugares dentro de um quilômetro</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>pares de números</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>dados de caminho</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>elementos e atributos</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>um desenho SVG</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>um comprimento</translation>
    </message>
    <message>
        <source>points</source>
        <translation>pontos</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>uma imagem ou um desenho</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>não há modelo 3D neste arquivo</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>um modelo 3D</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>uma unidade como millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>doze números</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>um objeto que não contenha a si mesmo</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n seção estava um pouco torta e foi endireitada.</numerusform>
            <numerusform>%n seções estavam um pouco tortas e foram endireitadas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n contorno se cruzava; ficou o laço maior.</numerusform>
            <numerusform>%n contornos se cruzavam; ficou o laço maior de cada um.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n furo passava do contorno e foi omitido.</numerusform>
            <numerusform>%n furos passavam do contorno e foram omitidos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n furo não tinha área e foi omitido.</numerusform>
            <numerusform>%n furos não tinham área e foram omitidos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Furos de %n seção se sobrepunham e foram juntados.</numerusform>
            <numerusform>Furos de %n seções se sobrepunham e foram juntados.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n furo passava do contorno e foi recortado dele.</numerusform>
            <numerusform>%n furos passavam do contorno e foram recortados dele.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>O texto depois da última seção foi ignorado em %n lugar.</numerusform>
            <numerusform>O texto depois da última seção foi ignorado em %n lugares.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>%n imagem ou malha não pôde ser lida e foi omitida.</numerusform>
            <numerusform>%n imagens ou malhas não puderam ser lidas e foram omitidas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>%n referência não pôde ser lida; o lugar dela foi mantido.</numerusform>
            <numerusform>%n referências não puderam ser lidas; os lugares delas foram mantidos.</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>a pasta não pode ser usada</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>está aberto em outra janela</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>lugares em que uma linha pode se cruzar</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>os dados estão danificados</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>uma malha com pelo menos um triângulo</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>uma aresta com três faces ou mais</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>uma malha em que duas faces se encontrem em cada aresta</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>o que devia seguir “%1” agora é um número comum</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n número não segue mais o que foi digitado.</numerusform>
            <numerusform>%n números não seguem mais o que foi digitado.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>uma imagem</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>um desenho</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>cada máquina uma vez, em sua ordem</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>retalhos</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>um contorno a partir de 0, 0 que não se cruze</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>espessuras</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>o que uma chapa pode ter</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materiais</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>o contorno está aberto: suas pontas estão a %1 mm uma da outra</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>coordenadas de até 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>objetos posicionados</translation>
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
        <translation>Diâmetro</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Retângulo</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Raio dos cantos</translation>
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
        <translation>Estrela</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Diâmetro interno</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Pontas</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Oblongo</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>Não pode ser feito</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF, em tamanho real</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, um por chapa</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF para programas antigos, R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>Modelos do FlatFitFab</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code para lasers GRBL</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code, um por chapa</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>Malhas glTF</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>Projeto do LightBurn</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, um por chapa</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>Malhas OBJ</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, sólidos no lugar</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, pele como malha</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>Malhas OFF</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Lista de peças para planilhas</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, uma página por chapa</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, dividido em folhas A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, dividido em folhas Carta</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>Malhas PLY</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Imagem das chapas</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Imagens, uma por chapa</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>Malhas STL</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, sólidos no lugar</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, pele como malha</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, sólidos deitados</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG, em tamanho real</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, um por chapa</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>Malhas 3MF</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, sólidos no lugar</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, sólidos deitados</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Tudo para a oficina, compactado</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Tudo para a oficina, em uma pasta</translation>
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
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; desfaz.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>Nada movido: onde %1 e %2 se encontram, não há duas fendas que dividam a profundidade.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>Nada mudou: %1 e %2 não podem ser unidas assim.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>Nada invertido: as fendas de %1 e %2 não podem abrir para o outro lado.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>Nada aparado: %1 não está dentro de %2, ou não sobraria nada dela.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Mova para deslocar o corte; solte para deixá-lo ali. &lt;kbd&gt;Esc&lt;/kbd&gt; põe de volta.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>Não dá para desenhar em um plano visto de perfil: gire a vista para continuar.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Traço descartado: a seção dele não existe mais.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>Nada desenhado: não dá para fazer uma seção com esta linha. Desenhe-a como um só laço aberto.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>Nada desenhado: tudo está abaixo do chão, onde é cortado.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>Nenhum furo feito: ele precisa ficar dentro de %1 e deixá-la inteira.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>O furo passa da borda de %1 e foi recortado dela.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>O furo tocou outros em %1; agora são um só furo.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>Os furos de %1 fora do novo contorno foram omitidos.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe uma seção no chão em um só traço. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe uma seção no plano frontal em um só traço. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe uma seção no plano lateral em um só traço. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe uma seção paralela a %1 em um só traço. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Desenhe o novo contorno de %1 em um só traço. &lt;kbd&gt;Esc&lt;/kbd&gt; mantém o antigo.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe um furo em %1 em um só traço. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe um furo: comece na seção que vai recebê-lo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>Nada importado: nenhuma linha de %1 forma um contorno fechado. Elas podem ser gravadas.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n contorno de %1 não coube e ficou de fora.</numerusform>
            <numerusform>%n contornos de %1 não couberam e ficaram de fora.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 de fora; %3.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %2 e %3 de fora; %4.</translation>
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
            <numerusform>%n imagem</numerusform>
            <numerusform>%n imagens</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>%n linha foi lida</numerusform>
            <numerusform>%n linhas foram lidas</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 está inclinada em relação a %1: mova-a primeiro para o plano de %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 tem %n contorno, o que é demais: trace com menos detalhe ou suavize antes.</numerusform>
            <numerusform>%1 tem %n contornos, o que é demais: trace com menos detalhe ou suavize antes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nada traçado: nenhuma parte de %1 está desse lado do limiar.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: arraste do centro para fora; um clique faz um de tamanho padrão.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: arraste do centro para fora para recortar de %2.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para deixar deste tamanho; &lt;kbd&gt;Shift&lt;/kbd&gt; mantém os dois lados iguais. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Desenhe a primeira seção: pressione, desenhe a forma em um só traço e solte.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Arraste para girar a vista; arrastar com &lt;kbd&gt;Shift&lt;/kbd&gt; seleciona um grupo.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Arraste para fora de %1 para desenhar uma seção que a cruza; clique para selecioná-la.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Clique para selecionar %1. Arraste para girar a vista: não dá para desenhar em uma seção vista de perfil.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Arraste para mover o corte pelo modelo; &lt;kbd&gt;Esc&lt;/kbd&gt; o fecha.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Clique para selecionar o problema %1.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Arraste para mover o ponto; &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz um canto, as setas movem 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Arraste para curvar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz um canto, &lt;kbd&gt;Shift&lt;/kbd&gt; mantém a direção.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Clique duas vezes para adicionar um ponto aqui; arraste para curvar o contorno.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Clique para selecionar o encaixe de %1 e %2.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Arraste para deixar a fenda de %1 mais funda e a de %2 mais rasa; clique para selecionar o encaixe.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Arraste para deixar a fenda de %1 mais funda e a de %2 mais rasa; as setas movem 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Arraste para mover o peso de %1 em %2; clique para selecioná-lo.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>As setas movem 1&#x202f;mm o peso de %1 em %2; &lt;kbd&gt;+&lt;/kbd&gt; e &lt;kbd&gt;−&lt;/kbd&gt; o alteram, &lt;kbd&gt;Del&lt;/kbd&gt; o remove.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Arraste para mover a força de %1 em %2, ou a ponta para girá-la; clique para selecioná-la.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>As setas movem 1&#x202f;mm a força de %1 em %2; &lt;kbd&gt;+&lt;/kbd&gt; e &lt;kbd&gt;−&lt;/kbd&gt; a alteram, &lt;kbd&gt;Del&lt;/kbd&gt; a remove.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 é feita por %2: clique para editar todas; clique de novo para só esta.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Clique para selecionar só %1; arraste para fora dela para desenhar uma seção que a cruza.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Arraste uma alça redonda para mover o início ou o fim de %1; clique em uma seção para selecioná-la.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Arraste para mover o início de %1; clique para digitá-lo.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Arraste para mover o fim de %1; clique para digitá-lo.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Clique para ver de frente; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Clique para ver de trás; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Clique para ver da esquerda; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Clique para ver da direita; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Clique para ver de cima; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Clique para ver de baixo; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Clique para ver desta aresta; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Clique para ver deste canto; arraste para girar a vista.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Arraste para girar a vista; a roda dá zoom.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para deixar aqui: a fenda de %1 fica com %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Clique em um ponto de uma seção para pôr %1 ali. &lt;kbd&gt;Esc&lt;/kbd&gt; encerra.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Pressione em uma seção e arraste no sentido da força. &lt;kbd&gt;Esc&lt;/kbd&gt; encerra.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Pressione em uma seção e arraste para puxá-la e ver o que acontece; nada fica.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Solte para largar: nada fica.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Arraste para mover. &lt;b&gt;Clique&lt;/b&gt; para selecionar.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>Arraste a ponta para girar a força; uma seta mais longa empurra mais forte.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Solte para pôr o peso aqui. &lt;kbd&gt;Esc&lt;/kbd&gt; põe de volta.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Solte para empurrar aqui. &lt;kbd&gt;Esc&lt;/kbd&gt; põe de volta.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>Nenhum peso adicionado: clique em uma seção.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>Nenhuma força adicionada: pressione em uma seção.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Vale também para a cópia de %1; em &lt;i&gt;Propriedades&lt;/i&gt; dá para limitar a esta seção.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>Vale também para %n cópia de %1; em &lt;i&gt;Propriedades&lt;/i&gt; dá para limitar a esta seção.</numerusform>
            <numerusform>Vale também para %n cópias de %1; em &lt;i&gt;Propriedades&lt;/i&gt; dá para limitar a esta seção.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>O peso fica onde está: ali estaria fora de %1.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>A força fica onde está: ali estaria fora de %1.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Arraste para definir até onde %1 atrai referências.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Solte para que %1 atraia referências a até %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe na seção que será gravada ou clique nela. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Arraste para desenhar uma linha em %1; &lt;kbd&gt;Shift&lt;/kbd&gt; a mantém reta. Clique para pôr texto.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para manter a linha. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 é gravada na frente, a única face que o laser alcança; a vista girou para ela.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>Nada gravado: isso não está em %1.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>O caractere “%1” não pode ser gravado.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Arraste de um lugar a outro para medir; &lt;kbd&gt;Ctrl&lt;/kbd&gt; evita aderir. &lt;kbd&gt;Esc&lt;/kbd&gt; encerra.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Vá até o segundo lugar. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Clique ou arraste para medir de novo. &lt;kbd&gt;Esc&lt;/kbd&gt; limpa.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Arraste ao longo de algo cujo comprimento você conhece; o modelo inteiro acompanha. &lt;kbd&gt;Esc&lt;/kbd&gt; encerra.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Digite o comprimento que você quer; &lt;kbd&gt;Enter&lt;/kbd&gt; redimensiona o modelo inteiro. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>O modelo não pode ficar tão grande ou tão pequeno.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>O modelo não pode ser redimensionado tanto assim: %1 passaria dos limites.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Clique na seção em que se vai espelhar; arraste para girar a vista. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: transformar em círculo</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: transformar em elipse</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: endireitar as linhas</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: cantos em ângulo reto</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: afastar a fenda da borda</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>Agora é um círculo.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>Agora é uma elipse.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Linhas endireitadas.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Cantos em ângulo reto.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Afastada da borda.</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 fica onde foi desenhada: afastada da borda, sua fenda cortaria %2 em pedaços. Desenhe cruzando a borda, não ao longo dela.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Solte para começar %1 aqui: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Solte para terminar %1 aqui: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Arraste para fora de uma seção para desenhar com a caneta uma que a cruza; arraste aqui para girar a vista. &lt;kbd&gt;Esc&lt;/kbd&gt; guarda a caneta.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Arraste para fora de %1 para desenhar com a caneta uma seção que a cruza; clique para selecioná-la.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Clique para marcar o primeiro ponto, arraste para curvar. &lt;kbd&gt;Esc&lt;/kbd&gt; guarda a caneta.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Clique para marcar um ponto, arraste para curvar; &lt;kbd&gt;Enter&lt;/kbd&gt; fecha, &lt;kbd&gt;Backspace&lt;/kbd&gt; tira um.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Clique para marcar um ponto, arraste para curvar; &lt;kbd&gt;Enter&lt;/kbd&gt; fecha, &lt;kbd&gt;Backspace&lt;/kbd&gt; tira um. &lt;kbd&gt;Ctrl&lt;/kbd&gt; + clique evita aderir.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>O contorno se cruza: &lt;kbd&gt;Enter&lt;/kbd&gt; fica com o laço maior, &lt;kbd&gt;Backspace&lt;/kbd&gt; tira um ponto.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Arraste para curvar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz um canto, &lt;kbd&gt;Shift&lt;/kbd&gt; mantém a direção.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Arraste para mover o ponto; &lt;kbd&gt;Ctrl&lt;/kbd&gt; evita aderir, &lt;kbd&gt;Shift&lt;/kbd&gt; mantém a direção.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Arraste a alça para curvar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz um canto.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Clique para fechar o contorno; arraste para mover o ponto.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; marca o ponto, &lt;kbd&gt;Tab&lt;/kbd&gt; vai para o próximo número. &lt;kbd&gt;Esc&lt;/kbd&gt; fecha a barra.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Não fechado: os pontos ainda não cercam nada.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Um contorno ainda está aberto: &lt;kbd&gt;Enter&lt;/kbd&gt; fecha, &lt;kbd&gt;Esc&lt;/kbd&gt; desfaz.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Até agora: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Até agora: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; conclui.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; conclui. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Solte para deixar aqui. &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz um canto, &lt;kbd&gt;Shift&lt;/kbd&gt; mantém a direção.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Solte para deixar assim. &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz um canto, &lt;kbd&gt;Shift&lt;/kbd&gt; mantém a direção.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para deixar assim. &lt;kbd&gt;Ctrl&lt;/kbd&gt; faz cantos nas pontas. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>Aqui o contorno se cruzaria; ele fica como estava logo antes.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Aqui um furo tocaria a borda ou outro furo; ele fica como estava logo antes.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>Aqui %1 seria toda cortada pelo chão; ela fica como estava.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>Nada excluído: um contorno precisa de pelo menos dois pontos.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para selecionar tudo o que está inteiro aqui dentro. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para selecionar os pontos de dentro. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 mantém o ângulo com %2. Solte-a da seção-mãe para girá-la como quiser.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 não está em outra seção; por isso, não tem ângulo com nenhuma.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 não pode ficar em %2, que está nela.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 e %2 não se encontram: primeiro mova uma delas até cruzar a outra.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Clique na seção em que %1 deve ficar. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Arraste para girar a vista; &lt;kbd&gt;Espaço&lt;/kbd&gt; reproduz, &lt;kbd&gt;←&lt;/kbd&gt; e &lt;kbd&gt;→&lt;/kbd&gt; vão passo a passo. &lt;kbd&gt;Esc&lt;/kbd&gt; fecha os passos.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>O modelo mudou; por isso, a vista dos passos foi fechada.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Continue arrastando até sair de %1; a fenda termina na borda. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Continue arrastando até sair de %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; deixa a fenda como você a desenha. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>A vista está girando: continue a desenhar já ou espere até ela parar.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Desenhe o contorno: saia da zona cinza onde ele deve começar. Solte aqui para cancelar.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Desenhe o contorno e solte para fechá-lo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para fazer a seção. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para cortar o furo em %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para dar a %1 este contorno. &lt;kbd&gt;Esc&lt;/kbd&gt; mantém o antigo.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para fazer a seção, espelhada na fenda. Segure &lt;kbd&gt;Shift&lt;/kbd&gt; para ficar só com este lado. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para fazer a seção, espelhada. Largue &lt;kbd&gt;Shift&lt;/kbd&gt; para ficar só com este lado. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para dar a %1 este contorno, espelhado na fenda. &lt;kbd&gt;Shift&lt;/kbd&gt; faz o contrário.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Solte&lt;/b&gt; para fazer a seção, espelhada na vertical. Segure &lt;kbd&gt;Shift&lt;/kbd&gt; para ficar só com este lado.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Siga a curva azul-esverdeada para aderir a %1; segure &lt;kbd&gt;Ctrl&lt;/kbd&gt; para não aderir. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; usa a curva inteira.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Shift+Enter: usar a guia inteira</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>A fenda não toca nenhuma guia; por isso, não há nenhuma para usar inteira.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>Nada desenhado: a fenda não saiu de %1. Comece dentro e arraste até cruzar a borda; &lt;kbd&gt;O&lt;/kbd&gt; desenha furos, &lt;kbd&gt;E&lt;/kbd&gt; grava.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>Nada desenhado: a linha é curta demais para cercar alguma coisa.</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Nada desenhado: uma linha de menos de %1 conta como escorregão da mão, a não ser que feche um laço.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>Nada desenhado: a linha vai e volta e não cerca nada.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>Nada desenhado: a linha se cruza e nenhum laço dela é grande o bastante.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 não foi espelhada: as duas metades não se encontrariam.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>O contorno se cruza; ficou o laço maior.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 foi espelhada; o que cruzou o eixo e voltou foi omitido.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 não chega à fenda: nada a une a %2.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 foi desenhada ao lado da fenda: ganhou uma haste e foi cortada rente ao chão.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 foi desenhada ao lado da fenda e ganhou uma haste que chega até ela.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 não é simétrica: as metades são diferentes.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Arraste uma seta para mover %1, um anel para girá-la, uma caixa para redimensioná-la; ou digite números. &lt;kbd&gt;Esc&lt;/kbd&gt; oculta as alças.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Arraste para mover; &lt;kbd&gt;Shift&lt;/kbd&gt; mantém uma só direção.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Arraste para girar.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Arraste para redimensionar.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para deixar assim. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 está bloqueada.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 não pode ser movida ou redimensionada tanto assim.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Arraste ao longo de algo em %1 cujo comprimento você conhece; &lt;kbd&gt;Shift&lt;/kbd&gt; mantém oito direções. &lt;kbd&gt;Esc&lt;/kbd&gt; encerra.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Digite quanto isso mede; &lt;kbd&gt;Enter&lt;/kbd&gt; deixa %1 desse tamanho. &lt;kbd&gt;Esc&lt;/kbd&gt; apaga a linha.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nenhum pedaço plano de %1 é grande o bastante para uma seção: aumente-a primeiro.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Ela tem mais de %1 pedaços planos: escolha menos faces.</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Uma chapa de %1 não dobra: escolha um material de %2 ou menos.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Dobre nas linhas vincadas e depois una as bordas de mesmo número: %n emenda.</numerusform>
            <numerusform>Dobre nas linhas vincadas e depois una as bordas de mesmo número: %n emendas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Clique na seção que quer mover ou girar, ou arraste-a. &lt;kbd&gt;Esc&lt;/kbd&gt; oculta as alças.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Arraste uma seta para mover, um anel para girar, uma caixa para redimensionar; ou digite números. &lt;kbd&gt;Esc&lt;/kbd&gt; oculta as alças.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Arraste para mover %1; clique para selecioná-la.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Arraste para mover; &lt;kbd&gt;Ctrl&lt;/kbd&gt; deixa uma cópia, &lt;kbd&gt;Shift&lt;/kbd&gt; mantém uma só direção.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Arraste para girar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; deixa uma cópia.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Arraste para redimensionar; &lt;kbd&gt;Ctrl&lt;/kbd&gt; deixa uma cópia.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para deixar assim. &lt;kbd&gt;Ctrl&lt;/kbd&gt; deixa uma cópia, &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Solte para deixar uma cópia aqui. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; deixa assim. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; faz %n cópia assim. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</numerusform>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; faz %n cópias assim, cada uma um passo adiante. &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Uma predefinição precisa de um nome, sem “=” e sem espaços no começo e no fim.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Ainda não há valor que outros possam ajustar; por isso, não há nada para guardar.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>Não há predefinição chamada “%1”.</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>É isto que os outros veem. Salve o arquivo e entregue a eles; ele abre assim.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n número que era feito dele agora é um número simples.</numerusform>
            <numerusform>%n números que eram feitos dele agora são números simples.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>%n predefinição que não define mais nada saiu junto.</numerusform>
            <numerusform>%n predefinições que não definem mais nada saíram junto.</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>Não foram encontrados intervalos mais estreitos em que o modelo aguente.</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Mova para girar a vista; solte para parar.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Mova para deslocar a vista; solte para parar.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Mova para cima para aproximar, para baixo para afastar; solte para parar.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>Nada mudou: isso não pode ser feito aqui.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 está bloqueada. Desbloqueie-a na Estrutura para alterá-la.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 é feita por %2: edite a origem ou separe esta.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>Não sobraria nada de %1; ela fica como estava.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 foi cortada rente ao chão.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1 se partiu ao ser cortada rente ao chão; ficou o pedaço maior.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>Nada colado: no que foi copiado não há seções nem imagem.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>Nada copiado: o modelo já é simétrico.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>Nada excluído: um encaixe é onde duas seções se encontram. Exclua uma delas ou escolha o tipo “Nenhum”.</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>“%1” agora é o que está definido, no lugar do que era.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Desenhe primeiro uma seção: ainda não há nada para espelhar.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Desenhe primeiro uma seção: ainda não há nada para repetir ou dividir.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n borda não tem dedos: as chapas se encontram em ângulo muito aberto ou muito fechado, ou ela é curta demais ali. Menos faces ajudam, ou então fatias.</numerusform>
            <numerusform>%n bordas não têm dedos: as chapas se encontram em ângulo muito aberto ou muito fechado, ou elas são curtas demais ali. Menos faces ajudam, ou então fatias.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Adiciona uma imagem espelhada da seleção. &lt;kbd&gt;Enter&lt;/kbd&gt; espelha; &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>O que você muda de um lado muda também do outro. &lt;kbd&gt;Enter&lt;/kbd&gt; espelha; &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Iguala os dois lados uma vez; depois cada um é independente. &lt;kbd&gt;Enter&lt;/kbd&gt; espelha; &lt;kbd&gt;Esc&lt;/kbd&gt; cancela.</translation>
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
        <translation>Copo d’água</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Garfo</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Faca</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Colher</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Livro</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Vaso de planta</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Uma face foi omitida: um canto dela não existe.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>%n face foi omitida: um canto dela não existe.</numerusform>
            <numerusform>%n faces foram omitidas: um canto delas não existe.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Uma face foi omitida: a posição de um canto não é um número.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>%n face foi omitida: a posição de um canto não é um número.</numerusform>
            <numerusform>%n faces foram omitidas: a posição de um canto não é um número.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Uma face foi omitida: tem um canto repetido.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>%n face foi omitida: tem um canto repetido.</numerusform>
            <numerusform>%n faces foram omitidas: têm um canto repetido.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Uma face foi omitida: está repetida.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>%n face foi omitida: está repetida.</numerusform>
            <numerusform>%n faces foram omitidas: estão repetidas.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Uma face estava virada para o lado errado e foi invertida.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n face estava virada para o lado errado e foi invertida.</numerusform>
            <numerusform>%n faces estavam viradas para o lado errado e foram invertidas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>A superfície tem um furo: uma aresta está aberta.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>A superfície tem furos: %n aresta está aberta.</numerusform>
            <numerusform>A superfície tem furos: %n arestas estão abertas.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>Mais de duas faces se encontram em uma aresta.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>Mais de duas faces se encontram em %n aresta.</numerusform>
            <numerusform>Mais de duas faces se encontram em %n arestas.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>Em uma aresta se encontram faces que não podem ficar viradas para o mesmo lado.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>Em %n aresta se encontram faces que não podem ficar viradas para o mesmo lado.</numerusform>
            <numerusform>Em %n arestas se encontram faces que não podem ficar viradas para o mesmo lado.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>Estava do avesso e foi desvirada.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Um vão no corte foi fechado com uma curva suave.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n vão no corte foi fechado com uma curva suave.</numerusform>
            <numerusform>%n vãos no corte foram fechados com curvas suaves.</numerusform>
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
        <translation>Como</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 não diz o tamanho em mm ou polegadas; o retalho é tomado como %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: o contorno cruza a si mesmo; é usado o maior pedaço dele, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: linhas cortam o retalho em pedaços; é usado o maior, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: há linhas abertas no retalho; o que elas cercariam se fossem fechadas fica livre.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>Quantidade</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linha</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Incluindo as seções que já estão lá</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>Passo X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>Passo Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>Passo Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Repete seções ao longo de uma linha no espaço.</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>Matriz de %1</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Seções</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Clique nas seções a repetir.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transição</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Interpola entre seções.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>Transição de %1</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Clique nas seções da transição, em ordem.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Ao longo de</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Clique na seção que ela deve acompanhar.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Quantidade por vão</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Posicionamento</translation>
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
        <translation>Pontas lentas</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Correspondência</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Como desenhado</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Ao contrário</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Repetições</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescimento</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Tamanho da cópia</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Variar tamanho ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Variar ângulo ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Menor</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>No máximo</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramificação</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Põe no lugar das filhas de uma seção cópias dela com tudo o que está nela, vez após vez.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>Ramificação de %1</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Raiz</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Clique na seção que se ramifica.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Presa por</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Clique na seção que a segura: as cópias são presas do mesmo jeito.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Filhas</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Clique nas seções presas que as cópias devem substituir.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grade</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Divide uma seção grande demais em células que se mantêm unidas.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>Grade de %1</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Seção</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Clique na seção a dividir.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Caber na chapa</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Células</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Largura da célula</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Altura da célula</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Borda</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Reta com conectores</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Quebra-cabeça</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bordas</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Conectores por borda</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Tamanho do conector</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Folga</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Juntar sobras abaixo de</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Para a frente</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Para trás</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambos</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Mesma profundidade dentro</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>O mesmo comprimento de cada cópia fica dentro da outra seção</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Fileira</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Repete uma seção em fileira ao longo de outra.</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>Fileira de %1</translation>
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
        <translation>Estrela</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Engrenagem</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Furos</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Setor desenhado</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Setores</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Raio externo</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Raio interno</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Dente</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redondo</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrado</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapézio</translation>
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
        <translation>Estrela de %1</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>Furos de %1</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>Rosácea de %1</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>Engrenagem de %1</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Transforma uma seção em círculo, estrela ou engrenagem, ou abre nela furos assim.</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Clique na seção a moldar.</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Clique na seção a repetir.</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Ramo inteiro</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Com tudo o que está preso a ela</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Repetir por</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaçamento</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Até</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Não</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Pela espessura local</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direção</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Seção inteira</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>Ao longo da fenda</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidade</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>Não menos que</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Fora</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Dentro</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Ângulo com a borda</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>A volta toda</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Revolução</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Repete uma seção ao redor do contorno de outra.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>Leque de %1</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Planos</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>transversais a X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>transversais a Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>transversais a Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>transversais a X e Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>transversais a X e Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>transversais a Y e Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>ao longo de uma curva</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Fatias</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Por</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>Em cada direção</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Deslocamento</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>De todos os planos, como parte do espaçamento</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Menor pedaço</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>Em mm²; os menores são omitidos, e também os que são finos por inteiro</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Ocas</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Fica só uma parede ao longo do contorno</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parede</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Corta uma malha em seções que acompanham sua forma.</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Clique na seção cujo contorno ela deve acompanhar.</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Clique nas seções a que se aplica.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Aplica-se a</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Modelo inteiro</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Seleção</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Espelho</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Repete de um lado tudo o que é desenhado do outro.</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Clique na seção em que se vai espelhar.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>Plano de uma seção</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetria</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>Unir no plano</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotacional</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Repete ao redor de um eixo tudo o que é desenhado uma vez.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eixo</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Clique nas duas seções cuja fenda é o eixo.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fenda</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>como uma seção</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>em torno de Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>em torno de X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>em torno de Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Como</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Clique na seção à qual elas devem ser paralelas.</translation>
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
        <translation>ligado</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desligado</translation>
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
        <translation>%1 ainda não faz nada: escolha o que vai em “%2”.</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 perdeu a seção “%2”, que foi excluída. Não faz nada até que se escolha outra.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 não faz nada: suas seções não se cruzam.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 não faz nada: não há espaço dentro do intervalo.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 não tem nada para dividir: a seção cabe em uma só célula.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 não pôde ser calculada: faltam as seções dela.</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 parou em 1 seção.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 parou em %n seção.</numerusform>
            <numerusform>%1 parou em %n seções.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 seção de %1 foi omitida, pois não há nada que a segure.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%n seção de %1 foi omitida, pois não há nada que a segure.</numerusform>
            <numerusform>%n seções de %1 foram omitidas, pois não há nada que as segure.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 não faz nada: a referência não existe mais ou falta o arquivo dela.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 pedaço pequeno de %1 foi omitido.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%n pedaço pequeno de %1 foi omitido.</numerusform>
            <numerusform>%n pedaços pequenos de %1 foram omitidos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: imprima em 100 %</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Chapa %1, página %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Destacar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
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
        <translation>Espaço</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Acima</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abaixo</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Interrompido: %1. O cálculo é refeito quando o modelo muda.</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>Não foi possível calcular: %1. Motivo: %2.</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>o que dá para fazer com os problemas</translation>
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
        <translation>os encaixes e as fendas</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>as verificações</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>a ordem de montagem</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>se ele aguenta</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>quanto ele aguenta quando as seções flexionam</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>quanto cada ponto de uma seção aguenta</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>a pele</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>como as peças ficam nas chapas</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>o que os ímãs fazem com as referências</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>o que solta peças que se travam</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>Configurar o corte</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>Editar %1</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Trocar o material de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Trocar o material de %n seção</numerusform>
            <numerusform>Trocar o material de %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Inserir %1</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Pousar no chão</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alargar a base de %1</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Adicionar um pé a %1</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Unir %1 e %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>Mover %1 até %2</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>Mover %n seção até %1</numerusform>
            <numerusform>Mover %n seções até %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Inverter as fendas de %1</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Mover %1 por %2</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Tornar montável</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Apoiar %1 com um pé</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Esticar %1 até o chão</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>Esticar %n seção até o chão</numerusform>
            <numerusform>Esticar %n seções até o chão</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>Deixar %1 com %2 de espessura</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar %1 para 90°</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alargar %1 onde é fraca</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: inverter as fendas</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: ponto de encontro → %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: restaurar ajustes automáticos</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → em cruz</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → em cruz prolongado</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → caixa e espiga</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → linguetas</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → nenhum</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Aparar %1 em %2</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Redesenhar %1</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Desenhar um furo em %1</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Desenhar %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Traçar %1</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alterar a forma de %1</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>Pôr %1 em %2</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover o peso em %1</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Mudar o peso para %1</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Renomear o peso para %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Remover peso</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Empurrar %1</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover a força em %1</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Girar a força em %1</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Mudar a força para %1</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Renomear a força para %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Remover força</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Distribuir a carga em %1</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Carregar também as cópias de %1</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Não carregar as cópias de %1</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Atrair referências para %1</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Atrair referências para %n seção</numerusform>
            <numerusform>Atrair referências para %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Liberar referências de %1</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Liberar referências de %n seção</numerusform>
            <numerusform>Liberar referências de %n seções</numerusform>
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
        <translation>Alterar a marca de %1</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Excluir a marca de %1</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Redimensionar o modelo para %1 %</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Transformar %1 em círculo</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Transformar %1 em elipse</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Transformar o furo em %1 em círculo</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Transformar o furo em %1 em elipse</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Endireitar as linhas de %1</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Pôr os cantos de %1 em ângulo reto</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Afastar %1 da borda</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Adicionar ponto a %1</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Excluir ponto de %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>Excluir %n ponto de %1</numerusform>
            <numerusform>Excluir %n pontos de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover alça de %1</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Curvar o contorno de %1</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mover ponto de %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>Mover %n ponto de %1</numerusform>
            <numerusform>Mover %n pontos de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alterar ponto de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>Alterar %n ponto de %1</numerusform>
            <numerusform>Alterar %n pontos de %1</numerusform>
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
            <numerusform>Mover %n seção</numerusform>
            <numerusform>Mover %n seções</numerusform>
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
            <numerusform>Girar %n seção</numerusform>
            <numerusform>Girar %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Redimensionar %1</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>Redimensionar %n seção</numerusform>
            <numerusform>Redimensionar %n seções</numerusform>
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
            <numerusform>Copiar %n seção</numerusform>
            <numerusform>Copiar %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Espelhar uma cópia de %1</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Espelhar cópia de %n seção</numerusform>
            <numerusform>Espelhar cópias de %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Tornar %1 perpendicular</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>Tornar %n seção perpendicular</numerusform>
            <numerusform>Tornar %n seções perpendiculares</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Alinhar %1 a um eixo</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>Alinhar %n seção a um eixo</numerusform>
            <numerusform>Alinhar %n seções a um eixo</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Pôr %1 em outra seção</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Soltar %1</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>Soltar %n seção</numerusform>
            <numerusform>Soltar %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Prender %1</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>Prender %n seção</numerusform>
            <numerusform>Prender %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Alterar como %1 acompanha</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Alterar como %n seção acompanha</numerusform>
            <numerusform>Alterar como %n seções acompanham</numerusform>
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
            <numerusform>Bloquear %n seção</numerusform>
            <numerusform>Bloquear %n seções</numerusform>
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
            <numerusform>Desbloquear %n seção</numerusform>
            <numerusform>Desbloquear %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>Posicionar %1 na chapa</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>Fixar %1</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>Fixar %n peça</numerusform>
            <numerusform>Fixar %n peças</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>Desafixar %1</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>Desafixar %n seção</numerusform>
            <numerusform>Desafixar %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Desafixar todas as peças</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Alterar a rotação de %1</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Alterar a rotação de %n seção</numerusform>
            <numerusform>Alterar a rotação de %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Manter %1 simétrica</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>Manter %n seção simétrica</numerusform>
            <numerusform>Manter %n seções simétricas</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Deixar diferentes as metades de %1</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Deixar diferentes as metades de %n seção</numerusform>
            <numerusform>Deixar diferentes as metades de %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Adicionar referência %1</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Remover referência %1</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Alterar referência %1</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Mover referência %1</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Girar referência %1</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Redimensionar referência %1</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>Alinhar %1 e %2</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ocultar referência %1</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Mostrar referência %1</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Sugerir %n seção para %1</numerusform>
            <numerusform>Sugerir %n seções para %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Fazer facetas de %1</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Planificar %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>Adicionar %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>Definir %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>Renomear %1 para %2</translation>
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
        <translation>Excluir %1</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Guardar a predefinição %1</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Mudar para %1</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Excluir a predefinição %1</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Entregar para ajustes</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Editar o projeto</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Definir os valores</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Estreitar os intervalos</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>Renomear %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Excluir %n seção</numerusform>
            <numerusform>Excluir %n seções</numerusform>
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
        <translation>Alterar %1</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Alterar a ordem de %1</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Omitir %1</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>Omitir %n seção</numerusform>
            <numerusform>Omitir %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Trazer de volta uma seção omitida</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Recortar %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>Recortar %n seção</numerusform>
            <numerusform>Recortar %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Colar %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>Colar %n seção</numerusform>
            <numerusform>Colar %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Manter cota</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Excluir cota</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Tornar simétrico</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Ligar %1</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Desligar %1</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Converter %1</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Separar %1</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Remover furos de %1</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Remover furos de %n seção</numerusform>
            <numerusform>Remover furos de %n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Deslocar planos de %1</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Alterar número de planos de %1</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Alterar espaçamento dos planos de %1</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 é pequena ou fina demais para seções de %2 de espessura.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Não foram encontradas seções de %1 que segurem umas às outras e fiquem de pé.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Não foi encontrada mais nenhuma seção de %1 que caiba entre as que já existem.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Só foi encontrada %n seção de %1: qualquer outra atrapalharia esta ou não seria segurada por nenhuma.</numerusform>
            <numerusform>Só foram encontradas %n seções de %1: qualquer outra atrapalharia estas ou não seria segurada por nenhuma.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n seção de %1 é o mínimo encontrado que fica de pé.</numerusform>
            <numerusform>%n seções de %1 são o mínimo encontrado que fica de pé.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 foi baixada %2 para dentro do chão, para que suas seções fiquem apoiadas em um pé plano.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 foi baixada %2 para dentro do chão, e suas seções têm pés de até %3 de altura, para ficarem de pé.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>Ela se move; só o primeiro quadro é mostrado.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n texto foi omitido.</numerusform>
            <numerusform>%n textos foram omitidos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n imagem foi omitida.</numerusform>
            <numerusform>%n imagens foram omitidas.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Falta um número, um nome ou uma conta.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Uma expressão tem no máximo %1 caracteres; esta é mais longa.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>Em “%1” a expressão tem mais de %2 números, nomes e sinais.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>Em “%1” há mais de %2 parênteses ou sinais uns dentro dos outros.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1” não pode ser lido aqui.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Falta algo depois de “%1”.</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Falta algo antes de “%1”.</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Entre “%1” e “%2” falta um sinal, como + ou *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>O parêntese em “%1” não está fechado.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Depois de “%1” há um parêntese de fechamento a mais.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>Faltam as aspas de fechamento no texto em “%1”.</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>“%1” pode ser um número ou dois: escreva um ponto, ou um espaço depois da vírgula.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>“%1” é uma unidade; antes dela vai um número.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>“%1” pode ser entendido de dois modos: ponha “%2” entre parênteses.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>“%1” é uma segunda comparação; and(…; …) une duas delas.</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>Não há função chamada “%1”.</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>“%1” leva %2 entre os parênteses, não %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>“%1” leva pelo menos %2 entre os parênteses, não %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>“%1” leva no máximo %2 entre os parênteses, não %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Não há valor chamado “%1”.</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>“%1” é a espessura do material; aqui não há um material único.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>“%1” é %2, portanto não pode ter unidade própria.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>“%1” é %2 e “%3” é %4; só o que é do mesmo tipo pode ser somado ou comparado.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>“%1” é %2; não dá para calcular com isso.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>“%1” é %2; aqui é preciso %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>“%1” é %2; só pode ser elevado a um número inteiro pequeno, como 2, e não a “%3”.</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>“%1” multiplica comprimentos, ângulos ou massas demais.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>“%1” é %2, que não tem raiz quadrada.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>“%1” é 0, e nada pode ser dividido por 0.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>“%1” é negativo e não tem raiz quadrada.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>A tangente de “%1” é infinita.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>“%1” não está entre −1 e 1, portanto não corresponde a nenhum ângulo.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>“%1” não é um número.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>“%1” não está acima de 0, e nada pode ser arredondado em passos assim.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>“%1” é grande demais.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>“%1” é %2, não é um número inteiro; round, floor ou ceil fazem dele um.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>“%1” é %2; precisa ser pelo menos %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>“%1” é %2; pode ser no máximo %3.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>“%1” é “%2”, que não está entre as opções.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>“%1” resulta em um texto de mais de %2 caracteres.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Este valor é feito de si mesmo: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Este valor é feito de “%1”, que no momento não tem valor.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Dois valores se chamam “%1”.</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>“%1” não é um nome; um nome é uma letra seguida de letras, algarismos e _, no máximo %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>“%1” não pode ser um nome, pois significa algo nas expressões.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Este valor não existe mais.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>A chave em “%1” não está fechada.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>um número simples</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>um número inteiro</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>um comprimento</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>uma área</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>um volume</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>um ângulo</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>uma massa</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>um texto</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>um sim ou não</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>algo que não é comprimento, ângulo, massa nem número simples</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Seção %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Seções %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 e %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>Não existe o material “%1”. Escolha um do arquivo ou da lista de materiais, como Birch plywood, Acrylic ou Card.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 não deixa espaço para fendas no material %2: a folga dele é %3 mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 não serve para o material %2, que tem %3 mm de espessura.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>um arquivo %1</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>um arquivo %1 do %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1; ou %2</translation>
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
        <translation>Mostra esta ajuda.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>Nenhum arquivo foi indicado.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Arquivos demais: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Dá outro número a um valor com nome do modelo, ou tudo o que uma predefinição define; pode ser repetido.</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Espessura de todos os materiais.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Corta todas as seções deste material ou do material de um arquivo .fff.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Largura total que a máquina remove.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Folga acrescentada às fendas; menos de 0 para entrar sob pressão.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Diz, de cada coisa corrigida no arquivo, onde foi.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: encontrado: “%2”; esperado: %3.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: encontrado: “%2”; esperado: um número de %3 a %4.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: encontrado: “%1”; esperado: largura x altura em mm, como 600x400.</translation>
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
        <translation>Junte todas as %1 ripas: o que falta à largura delas para %2 mm, dividido por %1, é a largura de corte.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Pontes que prendem cada peça à chapa, e sua largura em mm, como 3:0.4 (nenhuma).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Começa e termina cada corte a esta distância ao lado da linha, na sobra (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Corta uma só vez as bordas de duas peças encostadas; com --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Escreve uma peça de teste no lugar das peças: fendas de larguras numeradas e ripas que revelam a largura de corte.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: encontrado: “%1”; esperado: um número de 0 a %2, depois dois-pontos e uma largura de %3 a %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: encontrado: “%2”; esperado: um número de 0 a %3.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Passo %1: comece com a peça %2</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Passo %1: comece um grupo à parte com a peça %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Passo %1: peça %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Passo %1: peças %2 juntas, unindo o que os passos %3 e %4 montaram</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Seções: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Encaixes: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 e %2 se encontram, mas nenhuma fenda permite que se encaixem.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Todas as seções se mantêm unidas.</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>uma peça de %1</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Não unidas ao resto: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Tamanho %1 × %2 × %3 mm (largura, altura, profundidade)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Massa %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Material %1, %2 mm, chapas de %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Peça %1: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, encaixes %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>Nada a cortar: o modelo não tem seções.</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>Nada a cortar: as fendas não deixam nada de nenhuma seção.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>Falta -o: indique o arquivo a escrever.</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: um arquivo precisa de um nome.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: este tipo de arquivo não pode ser escrito; esperado: %2.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Põe uma malha, uma imagem ou um desenho (SVG) ao lado do modelo, com esta maior dimensão em mm; pode ser usado várias vezes.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: encontrado: “%1”; esperado: um arquivo, ou um arquivo e seu tamanho em mm, como ball.stl@80.</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>O arquivo .fff a escrever; - é a saída padrão.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Redimensiona a malha para esta maior dimensão; sem isso, o tamanho que o arquivo diz, ou 254.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: encontrado: “%2”; esperado: um número inteiro de %3 a %4.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: este item é grande demais para a tira.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Comprimento: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Densidade: %1 %</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Peças: %1, chapas: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm, %3: %4 peças, %5 % coberta</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: uma peça é grande demais para a chapa.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: encontrado: “%1”; esperado: groups ou files.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: não existe a máquina “%1”; esperado: %2 ou um arquivo .json.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files precisa de um nome: a saída padrão é um arquivo só.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>As fendas são desenhadas com %1 mm de largura.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>As fendas são desenhadas com %1 mm de largura (%2 − %3 da largura de corte).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Chapas de uma exportação anterior ainda estão lá: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Retalhos: %1, triângulos: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Vãos que ficam abertos: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: %2 m de corte, cerca de %3 min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>As chapas são maiores que a mesa de %1 x %2 mm; escolha outras com --sheet.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Peças: %1, chapas: %2, %3 % de uso.</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>O arquivo a escrever; - é a saída padrão.</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1; necessário se o nome do arquivo não disser.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Omite a barra de 100 mm ao lado das chapas.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Da borda da chapa ao corte mais próximo (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Entre cortes vizinhos (2).</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Só quartos de volta, para chapas com veio.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Dispõe as peças pelos contornos reais, buscando por tantos segundos; 0 fica com a primeira disposição (pelos retângulos delas).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: um SVG com um grupo por chapa; files: OUT-1.svg, OUT-2.svg e assim por diante (groups).</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>A máquina que corta, por suas cores, velocidades e G-code: %1; ou um arquivo .json com a sua própria (generic).</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Escreve a forma que as seções sugerem, como uma superfície (%1), no lugar dos sólidos.</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Com -o - falta o formato: --format %1.</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: este tipo de arquivo não pode contê-la; esperado: %1.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: este tipo de arquivo não pode contê-la; esperado: %1.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Pixels da imagem (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 a iso4, front, right, top, left, back, bottom ou fit: de novo a frente (iso1).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: encontrado: “%1”; esperado: largura x altura em pixels até %2, como 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: encontrado: “%1”; esperado: um de %2.</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Fica de pé.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Tomba.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Tomba: só tem uma linha em que se apoiar.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Uma parte dele não tem onde se apoiar.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>Ele não está no chão.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Escorrega pelo chão.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>As partes dele se movem umas contra as outras.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Aguenta.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Mal aguenta: pode trincar em um canto.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Quebra.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Um encaixe se abre.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>A resistência só é calculada para o que fica parado.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Sem avaliação: a resistência de um material não é conhecida.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Não foi possível calcular se aguenta.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Ficaria de pé %1.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Fraco demais: aguenta, mas não com a segurança pedida.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Aguentaria %1.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 pressiona o chão com %2 N.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>O encaixe %1–%2 se abre com %3 N: cole-o ou inverta as fendas.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>Não foi possível calcular como %1 flexiona; ela é tratada como rígida.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>Não foi possível calcular como as seções flexionam; elas são tratadas como rígidas.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Os encaixes podem dividir a carga de mais de um modo (indeterminado, %1); vale o pior.</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>A tensão em %1 não pôde ser calculada.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 não é avaliada: a resistência do material dela não é conhecida.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Uma força de %1 N não atinge o material de %2; o ponto mais próximo a recebe.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Um peso de %1 não está sobre o material de %2; o ponto mais próximo o recebe.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 no total</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1 N no total</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 vezes a carga</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>O mais fraco em %1: %2 da resistência do material no trecho estreito, %3 no canto.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Flexiona %1 mm, sobretudo %2.</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Pode trincar a partir de %1.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Quebra com %1.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Pesa %1 N com tudo o que está nele.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>encontrado: “%1”; esperado: NOME=VALOR, como width=400.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>encontrado: “%1”; esperado: NOME=VALOR, como width=400, ou uma predefinição: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>“%1” pode ser %2 ou %3; escreva um destes.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>o modelo não tem valores com nome.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>não existe o valor “%1”; esperado: %2.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Nenhum valor que outros possam ajustar tem intervalo e é usado.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Testados: %1 de %2 cantos dos intervalos, %3 variantes entre eles.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Todos estão bons.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 de %2 falham:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Onde:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Faces: %1, cascas: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>O plano não a corta.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Furo: %1 mm², %2 pontos</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Laço: %1 mm², %2 pontos</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Área: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Um ponto do plano e sua normal, seis números com vírgulas.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Primeiro redimensiona a malha para esta maior dimensão e a apoia no chão.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Escreve JSON, para outros programas.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>Falta --plane.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: encontrado: “%1”; esperado: seis números, dos quais os três últimos são uma direção.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Sem dedos onde as chapas se encontram a menos de 30° ou mais de 150°: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Sem dedos onde uma chapa passa da outra ou não chega até ela: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Sem dedos em bordas curtas demais para três deles: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Uma chapa de %1 mm não dobra; esperado: no máximo %2 mm; --stock escolhe outra.</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: ela tem %2 pedaços planos; esperado: no máximo %3; --faces os reduz.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: nenhum pedaço plano dela é grande o bastante para uma seção; --size a aumenta.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Planificações: %1, dobras: %2, emendas: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Primeiro simplifica a malha para esta quantidade de triângulos; os que estão no mesmo plano são um só pedaço.</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Planificações para dobrar em linhas vincadas, de chapa de até 3 mm, em vez de chapas planas.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Com --unfold: largura das abas de cola; 8 mm para chapa de até 1,5 mm, senão 0 mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap é de --unfold.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Pedaços pequenos demais para uma seção: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Seções: %1, encaixes: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Por quanto tempo buscar (10); 0 fica com a primeira disposição.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Outro número dá outra disposição; o mesmo, a mesma.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Como as peças podem ser giradas: none (não podem), 180, 90 ou free (livre).</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Da borda da chapa ao corte mais próximo.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Entre cortes vizinhos.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: encontrado: “%1”; esperado: none, 180, 90 ou free.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>O modelo não tem operações.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 seção</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desligada</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Escreve JSON, para outros programas; os passos são contados a partir de 0.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Maior distância entre cordas e curvas (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: este tipo de arquivo não pode ser escrito; esperado: .png.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: encontrado: “%1”; esperado: labels, checks, stress, forces, skin, ou vários separados por vírgulas.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: nenhuma força é mostrada; ele não fica de pé ou elas não puderam ser calculadas. “check” diz por quê.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>O arquivo PNG a escrever; - é a saída padrão.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: os nomes das seções; checks: destaca seções com problema; stress: as seções transversais mais fracas; forces: o que os pés e os encaixes sustentam; skin: a forma que as seções sugerem.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Tensão por elementos finitos, em cores por todas as seções; leva segundos.</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Uma imagem precisa de uma tela com OpenGL 3.3; não há nenhuma.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>Não foi possível escrever a imagem como arquivo PNG.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>O modelo do qual partir; sem ele, um novo.</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: encontrado: “%1”; esperado: X, Y, Z, XY, XZ, YZ ou radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>--count e --spacing foram indicados juntos; esperado: só um deles.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: planos ao redor de um eixo não têm espaçamento; esperado: --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>Os eixos a que os planos são transversais: X, Y, Z, dois deles para uma grade, ou radial: ao redor do eixo vertical (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Planos em cada direção (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>De plano a plano.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: nenhum plano corta dela uma seção grande o bastante.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size vale para .png; um PDF tem o tamanho do papel.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper vale para .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: encontrado: “%1”; esperado: a4 ou letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Passo %1 de %2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 ou letter (por padrão, o que é comum no seu país).</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Quantas seções (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Outro número dá outras seções (1).</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Predefinições: %1. Atual: %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Predefinições: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>O modelo não tem valores com nome.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Testa os intervalos dos valores que outros podem ajustar.</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Outro número testa outros lugares; o mesmo, os mesmos.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>há mais células do que nomes.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Um arquivo CSV: nomes de valores e uma linha de números para cada variante.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>A pasta onde escrever; é criada se não existir.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>O que se escreve de cada uma (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>--table e -o são necessários, os dois.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: encontrado: “%1”; esperado: um tipo de arquivo de corte.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: não foi encontrada nenhuma linha de números; esperada uma abaixo dos nomes.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: há aspas não fechadas.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: não foi possível criar a pasta.</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Põe um peso em uma seção, no meio ou em X,Y em mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Pode ser repetido.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: esperado: NOME=MASSA, como em &quot;Rib 4=350g&quot;.</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: esperada, depois do =, uma massa acima de 0 e até 1000000 kg, com g, kg, oz ou lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: não existe a seção “%2”.</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: as fendas não deixam nada de “%2”.</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: duas colunas se chamam &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: este tipo de arquivo não pode ser escrito; esperado: .pdf, .html ou .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size vale para .png; uma página web se ajusta à tela.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>Não foi possível fazer uma imagem dos passos.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Um arquivo PDF com todos os passos (- é a saída padrão), OUT.html para uma página web em que se pode girar o modelo, também no celular, ou OUT.png para OUT-01.png, OUT-02.png e assim por diante.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: tantos retalhos do material %1 são demais.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Chapas de %1 que faltam: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>As etapas não estão entre os arquivos: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>As chapas de %1 não têm espaço dentro de margens de %2 mm.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: encontrado &quot;%1&quot;, esperado largura x altura em mm, como 300x200, ou um arquivo .svg, e atrás quantos há, como :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Tamanho de uma chapa, como 600x400; com :N atrás, quantas há.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: o modelo não tem o material &quot;%2&quot;; é cortado de %3.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: o modelo é cortado de %2. Diga de qual é este, como em &quot;%3=%1&quot;.</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Uma chapa de outro tamanho, ou o que sobrou de uma como o maior contorno de um arquivo .svg em tamanho real, que é usada antes das inteiras; com :N atrás, tantas delas. Em um modelo de vários materiais, com o nome do material na frente: &quot;Birch plywood=300x200&quot;. Pode ser repetido.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Deixa só paredes desta largura ao longo dos contornos e onde outras cruzam.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Grava os números de cada encaixe em uma cor própria, a mesma nas duas peças.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: este tipo de arquivo não pode contê-las; esperado %1.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Cortado uma só vez para duas peças: %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>Nenhuma borda de duas peças se encosta: nada é cortado uma só vez. Com --spacing 0, bordas retas podem se encostar.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>As fendas %1 a %2 têm folgas de %3 a %4 mm: encaixe a tira e dê ao material a folga da que servir.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>Sem espaço para as entradas e saídas de todos os cortes: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>Sobre o FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licenças</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Para relatos de erros</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Desenhe peças planas em 3D, veja na hora como elas se encaixam e corte-as. Funciona sem conta, e nada sai deste computador.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Baseado em “FlatFitFab: Interactive Modeling with Planar Sections”, de J. McCrae, N. Umetani e K. Singh (UIST 2014). Software livre sob a GNU General Public License, versão 3 ou posterior.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Com o que este programa é feito</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Texto da licença</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Este programa</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Janelas, arquivos e texto</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Geometria exata</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Vetores e matrizes</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Corte e deslocamento de contornos</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Leitura de desenhos</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Descompactação de desenhos</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modelos com imagens e malhas</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Componentes que o CGAL usa</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Números sem arredondamento</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Números com muitos algarismos</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Resultados que podem ser erros</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>O modelo em páginas web dos passos</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>Arquivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Exibir</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Seção</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>Operação</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>Verificações</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ajuda</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Ver de</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Painéis</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Desenhar em um plano</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Desenhar nela</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Organizar</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Selecionar</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Barra de ferramentas para ajustes</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>agora mesmo</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>há %n minuto</numerusform>
            <numerusform>há %n minutos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>há %n hora</numerusform>
            <numerusform>há %n horas</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>ontem</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>há %n dia</numerusform>
            <numerusform>há %n dias</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Mais antigo que o desenho</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: mais antigo que o desenho</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Vereditos</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>Aguenta</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>Sem flexão</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>A seção não está lá</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>Não fica de pé como está</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>Quebra como está</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistência desconhecida</translation>
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
        <translation>interrompido</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>não pôde ser calculado</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Números da ferramenta de desenho</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distância</translation>
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
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ângulo</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Cima</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Fora</translation>
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
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Cópias</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Mais antigo que o desenho</translation>
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
        <translation>Bom</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconhecido</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
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
            <numerusform>%1 em %n lugar</numerusform>
            <numerusform>%1 em %n lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 de %2: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Verificações</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>As verificações começam com a primeira seção.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Verificando…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Mais antigo que o desenho</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Ainda não há nenhuma seção para verificar.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Nenhum problema.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Ainda verificando; nenhum problema até agora.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Problema %1 de %2: %3.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Ainda verificando. Isto será feito assim que o resultado for conhecido.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>O modelo mudou; isto não pode mais ser feito.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Feito: %1.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Se você clicar: %1.</translation>
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
        <translation>Exportar para</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Buscar comando</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Digite o que você quer fazer</translation>
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
        <translation>Nenhum comando encontrado</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Tente outra palavra</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Salvar uma peça de teste</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 peça de teste</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Peça de teste salva em %1. Corte-a e encaixe a tira nas fendas; Exportar pergunta qual delas serviu.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: sem folga</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: %2 mais estreita</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: %2 mais larga</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Pontes</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>Esta quantidade de pequenas falhas no corte de cada peça a prende à chapa; 0: nenhuma</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Largura das pontes</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Entrada do corte</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Cada corte começa e termina a esta distância ao lado da linha, na sobra; 0: na linha</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>cortar uma vez</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Bordas comuns</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>De peças encostadas umas nas outras, onde o espaçamento é 0</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Qual das fendas numeradas de uma peça de teste segura melhor a chapa (para cortar: menu Arquivo, ou entre os arquivos para a oficina). Define a folga.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Fenda adequada</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>cerca de %n min</numerusform>
            <numerusform>cerca de %n min</numerusform>
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
        <translation>Mudar este comprimento redimensiona o modelo inteiro</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mudar este comprimento estica %1 entre os dois pontos</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Excluir esta cota</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Abrir um modelo</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Inserir um modelo</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Importar um desenho</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Adicionar uma referência</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>Nada inserido: %1 não tem seções.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Salvar o modelo</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Alterações não salvas</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Salvar as alterações em %1?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Sem salvar, elas se perdem.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Não salvar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Reverter à versão salva</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 está como foi salvo. Desfazer traz suas alterações de volta.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Abrindo %1…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Escolher outro arquivo</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Remover da lista</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Salvando %1…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Salvar em outro lugar…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Salvo em %1.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Alterado no disco</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 foi alterado por outro programa.</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>Sobrescrever o arquivo perderia essas alterações.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Salvar como…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescrever</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sem título</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Desenho</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Simetria local</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Espelhar um contorno em relação à fenda quando for desenhado de um só lado dela. Shift faz o contrário enquanto você desenha.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Espelhar a primeira</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Espelhar também a primeira seção, na vertical que passa pelo seu início</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>Rente ao chão</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Cortar rente ao chão: deixar de fora o que for desenhado abaixo dele</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Aderir</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>Aderir a pontos, linhas de alinhamento, chão e grade</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Vista gira</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>Com 90° você olha de frente para o novo plano; com menos, a seção em que você começou continua visível</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Tempo de giro</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Quanto tempo a vista leva para girar até o plano de uma nova seção</translation>
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
        <translation>Um furo, enquanto você o desenha</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Um novo contorno, enquanto você o desenha</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>Nova seção, enquanto você a desenha</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>O contorno vem a seguir</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fenda</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Em</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>Fenda própria</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Trechos de curva</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhuma</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>linguetas</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fechada</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>abre para cima, %1 de profundidade</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>abre para baixo, %1 de profundidade</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>abre para o lado, %1 de profundidade</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Não espelhada.&lt;/b&gt; As duas metades não se encontrariam na fenda.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Não espelhada.&lt;/b&gt; Você desenhou de um lado do eixo: %1 de um lado, %2 do outro. A simetria está desligada ou Shift está pressionado.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;Espelhada.&lt;/b&gt; Você desenhou de um lado do eixo: %1 de um lado, %2 do outro. Passe dele %3 ou mais para desenhar você mesmo os dois lados.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Nova seção</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Referência</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Segue</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Sobre a guia</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1 % do traço</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Maior desvio</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Só um número de cada vez pode seguir um valor.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Este número não pode seguir um valor.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Nenhuma. Clique em uma seção para omiti-la ou separá-la.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Mostrar de novo</translation>
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
        <translation>Exportar arquivos de corte</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Abrir a pasta depois</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Pele sobre %1</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 como sólidos</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 em %2 · %3 de corte</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Exportar mesmo assim</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Dispondo…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Alterar…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 e seguintes, em %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 em %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Substitui %1 em %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>sua pasta pessoal</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Chapa %1 de %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Lista de peças</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Chapa anterior (Page Up)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Próxima chapa (Page Down)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>Mostrar a chapa inteira</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Uma pele não tem chapas: o arquivo contém a forma que as seções sugerem, como uma superfície sobre os contornos.</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>Sólidos não têm chapas: o arquivo contém o modelo como ele está, em tamanho real, com as fendas.</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Chapa %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Não há nada para cortar.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Uso: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Dispondo as peças nas chapas…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>Qual material?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Medir de novo</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Espessura medida</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Meça com um paquímetro a chapa que vai cortar: as fendas são desenhadas na medida dela.</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>Qual chapa?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Largura da chapa</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Altura da chapa</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, %2 de espessura</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Tamanho próprio</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>Qual máquina?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Cores, camadas, velocidades e G-code como esta máquina e seu programa os usam, e o que ela remove de cada material</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, medido %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>Foi o que medi</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>%n retalho é usado primeiro.</numerusform>
            <numerusform>%n retalhos são usados primeiro.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Qualquer laser</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Nenhuma peça está em um retalho.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>%1 de %n retalho usado primeiro.</numerusform>
            <numerusform>%1 de %n retalhos usados primeiro.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2 vezes</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>Não pode ser cortado</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Verificando…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Nada que exija atenção.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Uma chapa de %1 não tem espaço dentro de margens de %2.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>A largura de corte de %1 é 0: as fendas ficam mais largas e as peças menores, no tanto que a máquina remove.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>As chapas são maiores que a mesa de %1, de %2. Escolha menores.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Largura de corte (total)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Folga da fenda</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Fenda desenhada</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposição</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaçamento</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Margem na borda</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Quartos de volta para uma chapa com veio</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm, abaixo das chapas</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Barra de medida</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Desenhada ao lado das chapas, sem ser cortada: meça-a na sua máquina para conferir o tamanho</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Qualquer ângulo</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Quartos de volta</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Meias-voltas</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Como desenhada</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Guardado para este material e a máquina escolhida</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>uma cor por encaixe</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Números dos encaixes</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>As duas peças de um encaixe têm o número na mesma cor: para papel e para máquinas em que se define o que fazer com cada cor</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>Em dúvida? Corte antes uma peça de teste…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>As fendas de %1 não deixam sobrar nada. Ela não é cortada.</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 é maior que a chapa. Fica em uma chapa do seu próprio tamanho.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 é estreita demais para levar o número.</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 tem um furo ou um recorte mais estreito que a largura de corte, que não é cortado.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 não tem espaço para os números de todos os encaixes.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n peça</numerusform>
            <numerusform>%n peças</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n chapa</numerusform>
            <numerusform>%n chapas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Exportando %1…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>Exportado para %3: %1 em %2.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>Exportado para %3: %1 em %2; as fendas são desenhadas com %4 de largura.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>Exportado para %3: %1 em %2; as fendas são desenhadas com %4 de largura (%5 − %6 da largura de corte).</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>Exportado para %2: %1 como sólidos.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Pele exportada para %1; %n vão fica aberto.</numerusform>
            <numerusform>Pele exportada para %1; %n vãos ficam abertos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Pele exportada para %1.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiais…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Exportar para outro lugar…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Chapas de uma exportação anterior ainda estão lá: %1.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>Não exportado: os arquivos existentes ficam.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>É preciso %n chapa de %1 a mais do que há.</numerusform>
            <numerusform>São precisas %n chapas de %1 a mais do que há.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Falta um número.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1” não pode ser lido aqui.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Falta algo depois de “%1”.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Um parêntese não está fechado.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>Há um parêntese de fechamento a mais.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>Nada pode ser dividido por 0.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Não há valor chamado “%1”.</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>Isto não é um comprimento; multiplique um comprimento por um número simples.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>Isto não é uma massa; multiplique uma massa por um número simples.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>“t” é a espessura do material; aqui não há um material único.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>linha %1</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 do %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>Nada foi aberto: nenhum arquivo foi indicado.</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 não é um modelo. O FlatFitFab abre %2.</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>Não foi possível abrir %1: o arquivo não está mais em %2. Nada foi alterado.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>Não foi possível abrir %1: %2. Nada foi alterado.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>Não foi possível abrir %1: %2 (%3). Nada foi alterado.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>O arquivo no disco ainda é o antigo.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nada foi escrito.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>a pasta %1 não existe</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>Não exportado: %1. %2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>Não foi possível salvar %1: %2. %3</translation>
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
        <translation>Mover um de seus pontos o deixa assim</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Seu centro, nas coordenadas da seção</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Furo %1</translation>
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
        <translation>Forma livre</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>Arquivo de corte</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Papel ou imagem</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Sólidos para imprimir ou renderizar</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Lista de peças</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Tudo para uma oficina</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>Qual arquivo?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>Para que serve?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Um arquivo por chapa</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Traçar</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Deitada em</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Chão</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Deitar no chão</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Pôr em pé, para ser vista de frente</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Pôr em pé, para ser vista da direita</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Seção</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Deitar na seção selecionada, com a qual passa a se mover</translation>
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
        <translation>Virar</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Como vista por trás</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Alinhar duas</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>As duas últimas imagens como frente e lado da mesma coisa: com a mesma altura e sobre o mesmo lugar</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Limiar</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>Quão escuro precisa ser para ser traçado</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavização</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>Quão redondos ficam os cantos</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contornos</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Fazer seções</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Seções a partir de seus contornos, no próprio plano</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Cortar furos</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Furos na seção em que ela está deitada ou que está selecionada</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Gravar</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Linhas na seção em que ela está deitada ou que está selecionada</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: demais para seções</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>encaixe se abre, %1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n encaixe se abre, até %1&#x202f;N</numerusform>
            <numerusform>%n encaixes se abrem, até %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modelos (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Desenhos (%1)</translation>
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
        <translation>Direita</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>Cima</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Fora</translation>
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
        <translation>Cópia: %1</translation>
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
        <translation>Ajuda</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Voltar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>Salvar as teclas em uma página</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documentos PDF (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>Teclas do FlatFitFab</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>Não foi possível gravar %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Histórico</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Todos os passos; escolher um volta até ele.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Todos os passos aparecerão aqui; volte a qualquer um deles.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>De volta ao começo. Clique em um passo posterior para refazê-lo.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>O modelo está como era depois de “%1”.</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Como foi aberto</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Novo modelo</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Salvo aqui</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Del remove uma seção; arrastar, ou Alt com uma seta, muda a ordem.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (excluída)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Escolher…</translation>
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
        <translation>Feita por uma operação</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Feita por</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Imagem de</translation>
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
        <translation>Transformar esta em uma seção desenhada; a operação continua a fazer as outras</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Feita de</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>O que se altera em uma delas vale para todas</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>Redesenhá-la; tudo o que é feito dela acompanha</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Encaixe</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Fendas</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Restaurar ajustes automáticos</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Seções</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>Abre</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Inverter as fendas</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fenda</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ângulo</translation>
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
        <translation>Ponto de encontro</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>lingueta, %1 de largura</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>fechada, %1 de comprimento, %2 de largura</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>%1 de profundidade, %2 de largura</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhuma</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 e %2 se sobrepõem.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Aparar %1</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Ponto de encontro %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>A fenda de %1 fica com esta parte da profundidade; a de %2, com o resto</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Definido à mão; o automático é 50&#x202f;%. %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Seções: %1 e %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Definido à mão; dá para restaurar o ajuste automático</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 abre</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>O lado para o qual a fenda de %1 abre; a de %2 abre para o outro</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>Em %1</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Deixar o programa escolher de novo o tipo, a direção e os pontos de encontro</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>Nada neste encaixe foi definido à mão</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>Selecionar o encaixe com %1</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Nenhum ainda</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>em cruz</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>em cruz prolongado</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>caixa e espiga</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>linguetas</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>sem encaixe</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>Em cruz</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>Em cruz prolongado</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Caixa e espiga</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Linguetas</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>A folga do material delas deixa uma fenda sem largura</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>As fendas não podem abrir para fora: há um furo no caminho</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>Em um ponto só poderiam deslizar para um lado; em outro, só para o lado oposto</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Nada as seguraria: há furos onde as fendas começariam</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>Uma seção passa da outra, deslizem como deslizarem</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Nenhuma das seções passa da outra</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Elas se encontram em mais de um ponto</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Nenhuma das seções passa por uma fenda fechada na outra</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>Uma seção só termina na outra</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Nenhuma das seções termina na face da outra</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>Não há espaço para linguetas e suas fendas</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Elas se encontram a menos de 30°</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Para a direita</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Para a esquerda</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Para cima</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Para baixo</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Para a frente</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Para trás</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Pressione as teclas</translation>
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
        <translation>Salvar em uma página para imprimir…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>Na vista</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>Desenhar a primeira seção</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>arrastar no meio</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Desenhar uma seção que atravesse outra</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>arrastar para fora e continuar</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Girar a vista</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>arrastar ao lado do modelo</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Chegar mais perto</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>roda</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Mover a vista</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>arrastar com o botão do meio</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selecionar</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clique</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Selecionar um grupo</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>Shift e arrastar</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Ver o que se pode fazer</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clique direito</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Adicionar um ponto</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>clique duplo no contorno</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Desenhar sem aderir</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>segurar Ctrl</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Disposição</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaçamento</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margem</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Chapa</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Peças em furos</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>Peças pequenas podem ficar nos furos das grandes</translation>
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
        <translation>Polegadas</translation>
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
        <translation>Peça</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteca</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Adicionar seleção</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>Pôr a seleção na biblioteca; sem seleção, o modelo inteiro</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Pasta…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>Escolher a pasta cujos modelos são mostrados aqui</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>As peças que você guarda aparecem aqui: selecione algumas seções e clique em Adicionar seleção.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Pasta da biblioteca</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>Nada adicionado: ainda não há nada desenhado.</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>Não foi possível criar a pasta da biblioteca %1.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 agora está na biblioteca.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 está na lixeira.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>Não foi possível mover %1 para a lixeira.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Adicionar ao modelo</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>Mover para a lixeira</translation>
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
        <translation>Força</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Onde age</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Só um peso</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>Também em kg, oz ou lb: 1,5 kg, 2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Água dentro</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Centro de massa</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>Altura acima do lugar: quanto mais alto, mais cedo o modelo tomba</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Intensidade</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N é mais ou menos o peso de 1 kg</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Direção X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Direção Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Direção Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Em</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>No plano da própria seção, a partir da origem dela</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Posição X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Posição Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Distribuição</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>Em um ponto</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>Sobre uma área</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Ao longo da borda</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Pendurado</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>Também nas cópias</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Cada cópia que operações fazem da seção carrega um igual</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Pesos e forças</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 renomeia, Del remove.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Forças</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Força</translation>
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
        <translation>Referência</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Atraída</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Curvar a referência até o plano desta seção, para que as guias das outras acompanhem o que foi desenhado</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>De até</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Barra de ferramentas</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Repetir e interpolar seções</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>O modelo não pode ser mostrado: o driver de vídeo não oferece OpenGL 3.3. Um driver mais novo pode ajudar.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>O modelo não pode ser mostrado nesta tela.</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Comece um novo modelo, continue um ou veja um exemplo.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Recuperado: %n modelo que não foi salvo</numerusform>
            <numerusform>Recuperados: %n modelos que não foram salvos</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Mostrá-los</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Recuperado: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Mostrar a pasta</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Este modelo está aqui para ser ajustado. “Editar o projeto” traz tudo de volta.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Ajuda: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Sugerir seções</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Quantas</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Sugerir</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Encontra seções que mostram a forma, seguram umas às outras e ficam de pé</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Mais uma</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Uma seção que cabe entre as que já existem</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Outras</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>Outras seções no lugar das últimas</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetas</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Fazer facetas</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>Constrói a forma com chapas planas com dedos ao longo das bordas. Antes, a malha é simplificada para esta quantidade de faces; as que ficam no mesmo plano são uma só chapa.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Planificar</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>Abre a forma no plano, para cortar de cartão em um ou poucos pedaços e dobrar em linhas vincadas. As bordas que se unem têm o mesmo número.</translation>
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
        <translation>Giro</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Marca %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Gravada</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Vincada</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Excluir esta marca</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Altura da letra</translation>
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
        <translation>Lendo %1…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 é grande demais para um modelo; por isso, ficou com %2. O tamanho está em Referências.</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 não informa unidade; por isso, ficou com %2. O tamanho está em Referências.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Malhas, imagens e desenhos (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Imagem colada</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>Na escala de %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Mensagem</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalhes</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fechar esta mensagem</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>E mais %n.</numerusform>
            <numerusform>E mais %n.</numerusform>
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
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>nada desenhado ainda</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Novas seções</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Material das próximas seções que forem desenhadas</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Editar o material</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>Mostra onde o modelo flexiona ou se solta, maior do que é. Nada é alterado.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproduzir</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>O movimento está reduzido: use o controle deslizante</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>Não se sabe como ele se move.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>Ligue “Seções flexionam” para ver como ele flexiona.</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Mostrado no momento em que começa a se desmontar.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Flexiona %1, mostrado %2 vezes maior.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Flexiona %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>Valores com nome</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Um nome é uma palavra de letras e algarismos, que não seja “t” nem uma unidade.</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Excluir este valor</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Seção %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>variado</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>No mínimo %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>No máximo %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Retalho</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Uma chapa de outro tamanho, usada antes das inteiras</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>De um desenho…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>O que sobrou de uma chapa, como o maior contorno de um arquivo SVG em tamanho real, com seus furos</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Largura do retalho</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Altura do retalho</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Quantos deste retalho</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Tirar este retalho</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, de um desenho</translation>
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
        <translation>Escolher outra</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Permitir mais</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Deixar assim</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Escolher</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Exceções</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Converter</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Transformar em seções desenhadas o que ela produz; a operação em si deixa de existir</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>Excluí-la com tudo o que ela produz</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Escolher</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Permitir mais</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Operações, em ordem</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 renomeia, Espaço oculta e mostra, Alt com uma seta muda a ordem.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desligada</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Oculta: mostrar</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ocultar</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Estrutura</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Filtrar por nome ou material</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Seções</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 renomeia, Espaço oculta e mostra.</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>As seções aparecem aqui à medida que você as desenha.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renomear</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, sendo desenhada</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Bloqueada: desbloquear</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Oculta: mostrar</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Ocultar</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Desenhe uma forma aqui com o botão esquerdo pressionado.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, e mais %n aqui</numerusform>
            <numerusform>%1, e mais %n aqui</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Calculando as fendas…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 desde o último ponto</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>Espelhada na fenda</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>Espelhada na vertical</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Cortada rente ao chão</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Chão %1 abaixo desta borda</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Fenda de %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Fenda de %1, %2</translation>
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
        <translation>Como resulta das seções</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Definido à mão</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Lista de peças</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Núm.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Quantidade</translation>
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
        <translation>Exibição</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Linhas de tensão</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Mostrar acima de</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Fração da resistência da chapa; menos que isso não é mostrado</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>elementos finitos</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Seções flexionam</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Onde encaixes dividem uma carga, a rigidez das seções decide quanto cada um sustenta. Demora um pouco.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Mapa de resistência</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Colore a seção selecionada conforme a massa que cada ponto dela aguenta, além do que já está no modelo. Demora um pouco.</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Pontos mais fracos</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Cargas</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Ponha um peso no modelo para ver quanto ele aguenta.</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Peso próprio</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>No chão</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Adicionar peso</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Adicionar força</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Rigor</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Fator de segurança</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>Quantas vezes a sua carga o modelo precisa aguentar para contar como resistente</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Fator de entalhe, no máximo</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>Quanto a tensão sobe nos cantos internos depende do comprimento do trecho estreito, até este fator; fendas de fundo redondo precisam de menos</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>por meses</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>Cargas ficam</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Um material então aguenta menos, conforme definido nele: o acrílico, só um quarto</translation>
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
        <translation>Remover esta força</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Remover este peso</translation>
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
        <translation>interrompido</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>não pôde ser calculado</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>a seção selecionada</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>selecione uma seção</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Desenhe uma seção para ver quanto ela aguenta.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Não foi possível calcular se aguenta.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Mais antigo que o desenho, calculando…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Não fica de pé; a tensão não é mostrada.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Um encaixe se abre; a tensão não é mostrada.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Resistência desconhecida: um material não tem avaliação. Informe a resistência dele em Materiais.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>Atualizado. Os encaixes podem dividir a carga de muitos modos; vale o pior.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>Atualizado. Todas as forças se equilibram.</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Flexiona %2.</translation>
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
        <translation>na fenda</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>na vertical</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>na horizontal</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Solta</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>Não se move com a seção em que está nem mantém o ângulo com ela</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueada</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Fica como está, a não ser que se mova a seção em que ela está</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simétrica</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>O que se altera nos pontos de uma metade vale para a outra</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Em</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Clique em outra seção para pô-la nela</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>Não está em outra seção</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Ângulo de encaixe</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Acompanha</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>em proporção</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>a ponta esquerda</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>a ponta direita</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>a ponta de baixo</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>a ponta de cima</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Como o lugar dela acompanha quando um valor estica a seção em que ela está: na medida em que essa se estica ali, ou mantendo a distância até uma ponta</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posição</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X do meio dela</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y do meio dela</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z do meio dela</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X da direção para a qual está voltada, de comprimento 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y da direção para a qual está voltada, de comprimento 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z da direção para a qual está voltada, de comprimento 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Voltada para</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>Ponto</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>Alça de entrada</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Ângulo de entrada</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Alça de saída</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Ângulo de saída</translation>
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
        <translation>Canto</translation>
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
        <translation>Predefinição</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>alterado</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nome da predefinição</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, quatro prateleiras …</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Guardar como predefinição o que está definido agora</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Excluir esta predefinição</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Guardar como predefinição</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Dá um nome ao que está definido agora, como A5, para voltar a isso depois</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 para fora</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 para dentro</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 alto demais</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Propriedades</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>Mais %n em Verificações.</numerusform>
            <numerusform>Mais %n em Verificações.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ligada</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Desligada, não faz nada, mas mantém seus ajustes</translation>
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
        <translation>%1 em %2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nada selecionado</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>As alterações valem para todas</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Elas se sobrepõem</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automático</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · definido à mão</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n encaixe</numerusform>
            <numerusform>%n encaixes</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Feita por %1 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Seção · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Seção · em %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · desligada</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · não faz nada</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · atualizada</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir recente</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (não encontrado)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Limpar esta lista</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Esquecer estes nomes; os arquivos ficam</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>A que prestar atenção</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Fecha isto e o seleciona no modelo</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Substituir arquivos</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>Substituir %n arquivo existente?</numerusform>
            <numerusform>Substituir %n arquivos existentes?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Substituir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>Substituir este arquivo?</translation>
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
        <translation>Ao longo de uma costela, de anel a anel</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>Ao longo de uma costela, até o anel inferior</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Arco</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>desvio</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>eixo_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>eixo_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Costas</translation>
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
        <translation>Costela da barriga</translation>
    </message>
    <message>
        <source>between</source>
        <translation>entre</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Prateleira</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Prateleiras</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>prateleiras</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corpo</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramificação</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>maiúscula</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Células</translation>
    </message>
    <message>
        <source>column</source>
        <translation>coluna</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colunas</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>colunas</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Berço</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>berço</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Frontão</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Talheres</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profundidade</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diâmetro</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distância</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Divisória</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Divisórias</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Orelhas</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Base de trás</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Dançarino de trás</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Dançarino de trás, inclinado</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Dançarinos de trás</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Pinheiro</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Pinheiro cruzado</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Fundo</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pé</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Patas dianteiras</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Garfos e colheres de chá</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Quatro prateleiras</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>De eixo a eixo, na horizontal</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>De eixo a eixo, com um pouco de folga</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>De parede a parede</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Pé dianteiro</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Patas dianteiras</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Travessa dianteira</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Onda da frente</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Copo d’água</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Alça</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeça</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Altura das maiúsculas; um nome comprido precisa ser menor</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Altura dos berços</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Altura do eixo do pinhão</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Altura do eixo da roda</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Pé traseiro</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Patas traseiras</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Onda de trás</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Quadril</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Chifres</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>Quanto uma costela se desvia do seu lugar embaixo ao chegar ao anel superior</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>Quanto cada costela se inclina</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>Quanto o pinhão fica mais baixo, visto da roda</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Largura da placa, em alturas de uma maiúscula</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Sua largura</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Potes</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Última costela</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Pata esquerda</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Folha esquerda</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Lateral esquerda</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Tira esquerda</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Asa esquerda</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Perna</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Pernas</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>pernas</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>letras</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Pé comprido</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>abaixo</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Anel inferior</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Ripa inferior</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Meio</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Base do meio</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Dançarino do meio</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Dançarino do meio, inclinado</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Dançarinos do meio</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Costela central</translation>
    </message>
    <message>
        <source>module</source>
        <translation>módulo</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Caneca</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Focinho</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nome</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Placa com nome</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Base da frente</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Dançarino da frente</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Dançarino da frente, inclinado</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Dançarinos da frente</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Pescoço</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>De uma costela, ao longo dela</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>Das prateleiras, de ponta a ponta</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Da gaveta, por dentro</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Do copo</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>Da parede mais alta</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Do pinhão, de um vão até a roda</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Do pinhão, da mesma forma</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>Das laterais</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>Das laterais; o frontão fica mais alto</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>Da roda</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>Da roda, até o fundo dos vãos</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>Da roda, até a ponta dos dentes</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Outro pé</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Outro pilar</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Outro corrimão</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Outra lateral</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Outra longarina</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Outra ponta do pé</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Canetas</translation>
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
        <translation>Pinhão</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>pinhão</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Dentes do pinhão</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>raio_pinhão</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>raiz_pinhão</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>pinhão_y</translation>
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
        <translation>raio</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Corrimão</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Raio da nadadeira</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Raios da nadadeira</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Costela traseira</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>resto</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Costela</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Costelas</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>costelas</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Pata direita</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Folha direita</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Lateral direita</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Tira direita</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Asa direita</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anel</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Anel de furos</translation>
    </message>
    <message>
        <source>root</source>
        <translation>raiz</translation>
    </message>
    <message>
        <source>row</source>
        <translation>fileira</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Fileiras</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>fileiras</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Parafusos</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Assento</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Bandeja</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Ombro</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lateral</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Laterais</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Longarina</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Tamanho dos dentes: o diâmetro dividido pelo número deles</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Fatias</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Copo pequeno</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Espinha dorsal</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Colheres e facas</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrela</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Cauda</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Dentes</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>dentes</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Dentes do pinhão</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>O mesmo sem os dentes inteiros</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Três prateleiras</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>inclinação</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Travessa</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>Travessas</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>Ponta do pé</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Dente</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Tronco</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>Copo</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>giro</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Raminho</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torção</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Anel superior</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Ripa superior</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Vértebras do pescoço</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Vértebras da cauda</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parede</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Baleia</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>O que cabe na chapa</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Roda</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Onde fica um dente da roda</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Larga</translation>
    </message>
    <message>
        <source>width</source>
        <translation>largura</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>larguras</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Peixe</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Cachorro salsicha</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Pinheiro</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Cúpula de abajur</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Cadeira de boneca</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Porta-copo</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Organizador de mesa</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Estante</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Organizador de gaveta</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Placa com nome</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Suporte de copo</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Urso sobre uma malha</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Coruja a partir de imagens</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Ouriço em fatias</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Espinha de peixe</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinossauro</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Besouro-veado</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Árvore que cresce</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Dançarinos em duas poses</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Passarela</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Engrenagens</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Baleia em células</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Boneco de talheres</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Copo sobre três pernas</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Três pernas finas: fraco demais</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Quatro pernas finas: fraco demais</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Três pernas grossas: por pouco</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Quatro pernas grossas: seguro</translation>
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
        <translation>começar criar vazio em branco</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>carregar importar flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>adicionar juntar anexar combinar mesclar</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>guardar gravar</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>copiar renomear</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>recarregar descartar</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>imprimir laser cortadora cortar cnc router plotter svg dxf pdf gcode lightburn fazer fabricar</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>preferências opções configurar escuro claro tema idioma língua unidades polegadas mouse navegação salvamento automático animação</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>teclas teclado hotkeys</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>encerrar fechar terminar</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf importar</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf importar gravar</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj imagem foto figura decalcar fundo gabarito</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>voltar ops</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>de novo avançar</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>área de transferência</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>copiar clonar</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>virar refletir simétrico</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>remover apagar deletar lixeira</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>todos todas</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>pesquisar procurar paleta</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoom centralizar centro ajustar</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom foco</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>olhar de frente reto</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>ortográfica isométrica paralela câmera</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>transparente aramado através</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>fatia dentro metade corte</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>superfície casca revestimento</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>solo sozinha</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>reexibir visível</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>esconder invisível</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>grade piso</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>compartilhar dar personalizar customizar configurar aluno turma ajustar controles bloqueado janela cheia</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>maximizar</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>barras laterais</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>layout padrão</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>espelhar metade</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>piso pés base</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>ímã alinhar guia encaixar snap</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>polígono linha curva bezier caminho</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>círculo quadrado retângulo polígono estrela</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>gravar texto letras marcar etiqueta</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>mover rotacionar girar escalar redimensionar</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>abertura janela recorte buraco</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>substituir</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>matriz padrão repetir fileira costelas linear</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>rotacionar ao redor volta</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>loft morph mesclar entre</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>árvore galho bifurcar</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>waffle colmeia treliça</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>raios roda engrenagem polar</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>girar polar padrão</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>padrão repetir cópias array</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>waffle camadas stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>converter explodir aplicar</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>erro aviso falha</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>montagem instruções animação reproduzir manual</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>resistência quebrar simulação física fem</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>carga massa força</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>empurrar empurrão carga</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>material espessura compensado mdf acrílico kerf largura de corte</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>peça de teste corpo de prova kerf folga fendas pente</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>nesting layout aproveitamento organizar</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>comprimento distância tamanho dimensão cota</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>escala tamanho escalar</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>manual tutorial documentação guia</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>início boas-vindas exemplos</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>versão licença</translation>
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
        <translation>Encaixes</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Editar o material</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Espessura do material: todas as seções deste material acompanham</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Como as outras</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Como as peças dela podem ser giradas na chapa: uma que segue o veio fica como desenhada ou com meias-voltas</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Outro comprimento estica o contorno em torno da fenda ou do meio</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Furos</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
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
        <translation>Configurações</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Grupos de configurações</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Geral</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Verificações</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Arquivos</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Teclado</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
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
        <translation>Polegadas (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>O que é mostrado e digitado. Os arquivos sempre guardam milímetros.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Cores</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Igual ao sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Escuro</translation>
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
        <translation>Vale depois de reiniciar.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Mostrar a página inicial ao abrir</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Tempo de giro</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Quanto tempo a vista leva, enquanto você desenha, para girar até o novo plano. Com 0, ela salta.</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>Vista gira</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>Com 90° você olha de frente para o novo plano. Com menos, a seção em que você começou continua visível.</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>Traços seguem uma referência a até</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Botões do mouse como em</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Que botões giram, movem e dão zoom na vista. Ctrl com o botão esquerdo sempre a gira, Espaço com o botão esquerdo a move.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Sempre</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>O mínimo possível</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Com o mínimo possível, a vista salta em vez de girar.</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Cores de tensão para daltônicos</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>De claro a escuro em vez de azul a vermelho. Sempre assim em alto contraste.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Avisar sobre ângulos abaixo de</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Quanto mais fechado o ângulo entre duas seções, mais largas precisam ser as fendas.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Ignorar sobreposições abaixo de</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Uma sobreposição menor que esta não é problema.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Procurar a ordem de montagem por</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>Em segundo plano, depois de cada alteração. Dê mais tempo se as verificações não encontrarem uma ordem.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Fator de segurança</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>Quantas vezes a sua carga um modelo precisa aguentar para contar como resistente.</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Fator de entalhe, no máximo</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>Quantas vezes maior se considera a tensão nos cantos internos.</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>Cargas ficam por meses</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Fazer cópia do que não foi salvo a cada</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Depois de uma falha ou queda de energia, você o recupera, mesmo que nunca tenha sido salvo. Seu arquivo não é tocado.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Manter a versão anterior ao salvar</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Janela simples</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Para desenhar, verificar e exportar; o resto sai da frente.</translation>
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
        <translation>Laser K40</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>Chapa inteira</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>Na chapa</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Chapa</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Posição X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>mantém o lugar</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Fixada</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P fixa e desafixa a peça selecionada nas chapas</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>grande demais para uma</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, sua primeira peça</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm, para conferir o tamanho</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Chapa, como será cortada</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Mais e menos dão zoom, as setas a movem, Home a mostra inteira.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>O retalho de %1 fica inteiro</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Chapas</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rápida</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Boa</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Melhor</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Qualidade da disposição das peças</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Rápida dispõe de novo todas as peças. Boa leva uns dez segundos. Melhor continua até você parar.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Dividir com Grade</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Desafixar todas</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Desenhe uma seção e ela ficará aqui, pronta para cortar.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Dispondo…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Dispondo de novo…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n peça fixada não tinha espaço onde estava.</numerusform>
            <numerusform>%n peças fixadas não tinham espaço onde estavam.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 é grande demais para a chapa.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 e mais %n são grandes demais para as chapas.</numerusform>
            <numerusform>%1 e mais %n são grandes demais para as chapas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Adicionar um retalho</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n chapa a mais do que há</numerusform>
            <numerusform>%n chapas a mais do que há</numerusform>
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
        <translation>mantém a melhor até agora, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Dispondo… %1 % de uso</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 em %2 · %3 % de uso · %4 de corte</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Chapas, como serão cortadas</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Page Up e Page Down vão de peça em peça, as setas movem uma peça 1 mm, R a gira, P a fixa. Mais e menos dão zoom, Home mostra todas as chapas.</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · girada %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>Não há espaço para ela.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>Ela não pode ser girada tão pouco.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Ela fica como desenhada.</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Chapa %1 de %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>Grande demais</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>veio ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n peça · %1 % de uso</numerusform>
            <numerusform> · %n peças · %1 % de uso</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Retalho, chapa %1 de %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Fixada: fica onde está. Clique para desafixá-la.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Arraste uma peça para outro lugar ou clique nela para selecioná-la.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Clique para desafixar &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; é grande demais para a chapa. Clique para selecionar.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Arraste &lt;b&gt;%1&lt;/b&gt; para outro lugar ou clique para selecionar.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Arraste &lt;b&gt;%1&lt;/b&gt; para outro lugar. &lt;kbd&gt;R&lt;/kbd&gt; gira, &lt;kbd&gt;P&lt;/kbd&gt; fixa.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtrar por nome ou teclas</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Nenhuma tecla para este comando</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>As teclas originais deste comando</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restaurar tudo</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>As teclas originais de todos os comandos</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>Usar aqui</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Comandos e seus atalhos</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atalho</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Funciona</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>na vista</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>em toda parte</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Escolha um comando</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Teclas para %1:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Alterado por você</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 sozinha atrapalharia a digitação. Segure Ctrl ou Alt junto; teclas sozinhas são para comandos que funcionam na vista.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 já pertence a “%2”.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Entre %1 ela incharia muito para fora: mais uma seção atravessada diz até onde.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Entre %1 ela se dobraria sobre si mesma.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Os contornos não dizem o que há entre %1.</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Pele: calculando… %1&#x202f;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Pele: calculando…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Pele: interrompida</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Pele: não pôde ser calculada</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Pele</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Pele: nada para cobrir</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Pele: nenhum contorno se cruza</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Clique para parar.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Uma pele precisa de seções que se cruzem e ali terminem no mesmo lugar.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n retalho</numerusform>
            <numerusform>%n retalhos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; %n vão fica aberto.</numerusform>
            <numerusform>%1; %n vãos ficam abertos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Clique para ver de novo só as seções.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Quadrado</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redondo</translation>
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
        <translation>Fundo da fenda</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>O fim interno da fenda. Um laser o corta quadrado; a ferramenta redonda de uma fresadora não alcança os cantos. Redondo: um fundo redondo além do quadrado. Dogbone: um arco em cada canto. T-bone: um arco em cada parede; o fundo continua reto.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Ferramenta</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Diâmetro da fresa. Os arcos são desenhados um pouco maiores, para que ela consiga contorná-los.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Um fundo quadrado não tem ferramenta. Escolha outro fundo da fenda para uma fresadora.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Chanfro de entrada</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Chanfro das duas paredes na boca da fenda, a 45°, para que as seções entrem com facilidade. O comum é de metade até toda a espessura; 0: nenhum.</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Ressaltos de aperto</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Altura de um pequeno ressalto em cada parede da fenda, que aperta a seção dentro dela. Precisa ser mais que a metade da folga; 0: nenhum.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>seção</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>seção gerada</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>em %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueada</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>tem um problema</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>sem problemas</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Encaixe de %1 e %2</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, operação</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 em %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n seção selecionada</numerusform>
            <numerusform>%n seções selecionadas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página inicial</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Novo</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Desenhe seu próprio modelo</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Abrir um modelo, também do FlatFab</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Sem conta; nada sai deste computador.</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Mostrar ao abrir</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recentes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemplos</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Abrir</translation>
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
        <translation>Mostrar a pasta</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>não encontrado</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Remover desta lista</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>Abrir uma cópia</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Primeiro modelo em 3 minutos</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Desenhar, verificar e cortar um modelo, um passo de cada vez</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>O que o próximo gesto faz</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Número de seções</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Tamanho do modelo</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Massa do modelo</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Unidade de todos os comprimentos</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>Desfeito: “%1”.</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>Desfeito: “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; traz de volta.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>Refeito: “%1”.</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>Refeito: “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; desfaz.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Passos da montagem</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Exportar passos…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Fechar os passos (Esc)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Passo anterior (seta esquerda)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Reproduzir (Espaço)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Próximo passo (seta direita)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>Afastar as peças umas das outras</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Explodido</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pausar (Espaço)</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Salvar todos os passos em um PDF para imprimir, em uma página web para celulares, ou uma imagem de cada um</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Todos os passos, para imprimir (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Imagens, uma por passo (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Exportar passos</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Exportando %1…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>Nada foi escrito: a exportação foi cancelada.</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>Não foi possível exportar os passos: nesta tela não dá para fazer imagens.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n passo</numerusform>
            <numerusform>%n passos</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>Exportado para %2: %1.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>Exportado para %2 … %3: %1.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Exportar para outro lugar…</translation>
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
        <translation>Este navegador não mostra o modelo em 3D. Aqui está o que fazer, passo a passo.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>Não há imagens: na tela do computador que salvou esta página não deu para fazer nenhuma.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Arraste para girar o modelo, use dois dedos ou a roda para ampliar, toque duas vezes para ver tudo.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproduzir</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Passo anterior</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Próximo passo</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Peças</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 peça</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n peça</numerusform>
            <numerusform>%n peças</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 chapa</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n chapa</numerusform>
            <numerusform>%n chapas</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 passo</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n passo</numerusform>
            <numerusform>%n passos</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>Como se monta</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, de %2, em %3.</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>Os números são os gravados nas peças. Em cada fenda está o número do seu encaixe depois de um tracinho, o mesmo nas duas peças.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e mais %n</numerusform>
            <numerusform>e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in %2.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;38 steps&quot;</extracomment>
        <translation>%1, em %2.</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsView</name>
    <message>
        <source>The model has changed, so its steps are not shown.</source>
        <translation>O modelo mudou; por isso, os passos não são mostrados.</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>Os passos não podem ser mostrados nesta tela.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>Os passos não serão mostrados.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>Calculando a ordem de montagem; os passos são mostrados assim que ela for conhecida.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Os passos não podem ser mostrados: %1.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>Agora a ordem de montagem é conhecida; “Mostrar os passos” a mostra.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Ainda não há nada aqui.&lt;/b&gt; Passo 1: %1</translation>
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
        <translation>Compensado de bétula</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Compensado de bétula 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Compensado de bétula 6,5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Compensado de bétula 9 mm</translation>
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
        <translation>Acrílico, transparente</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Acrílico, vermelho</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Papelão ondulado B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Papelão ondulado C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Papelão ondulado E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Cartão</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Tília</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM</translation>
    </message>
    <message>
        <source>Aluminium 6061</source>
        <translation>Alumínio 6061</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Use %1 for new sections</source>
        <translation>Usar %1 para novas seções</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: %2 → %3 de espessura</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Material da próxima seção</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Material da próxima seção: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiais…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Materiais</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Chapa</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Chapa L × A</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidade</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>não conhecido</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 significa não conhecido</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Preço da chapa</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Largura da chapa</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Altura da chapa</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Chapas comuns</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Resistência</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Resistência à tração</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Resistência à flexão</translation>
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
        <translation>antes de quebrar</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Entorta</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Como metal: acima destas resistências, fica torto</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Aguenta por meses</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Fração da resistência sob uma carga que fica: o acrílico se deforma e racha aos poucos</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Largura de corte</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Folga da fenda</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Fenda desenhada</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Fendas</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>sem avaliação</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 significa sem avaliação</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>Nenhuma seção é feita dele</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>nenhuma: a largura de corte é maior que a fenda</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Espessura, folga e largura de corte de duas seções deste material perpendiculares uma à outra</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Vendido como</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>A espessura com que se compra a chapa; em geral não é bem essa</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>com paquímetro, por mim</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>A exportação pergunta uma vez a espessura das chapas que você vai cortar</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>quantas forem precisas</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 significa quantas forem precisas</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Quantas há</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Usados primeiro</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Um retalho de um desenho</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Desenhos (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Por máquina</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Guardado onde uma largura de corte foi digitada enquanto essa máquina estava escolhida na exportação</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Tamanho e quantidade</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Materiais deste modelo</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Adicionar</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Adicionar um material da lista pronta</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Adicionar um material com os mesmos números</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Salvar este material em um arquivo, para outros modelos e outras pessoas</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Salvar o material em um arquivo</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Remover o material</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n seção</numerusform>
            <numerusform>%n seções</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Um modelo precisa de um material; adicione outro primeiro</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Remover este material</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>De um arquivo…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Adicionar um material de um arquivo</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>Modelos do FlatFitFab (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Fazer a %n seção dele de</numerusform>
            <numerusform>Fazer as %n seções dele de</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Adicionar material %1</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Remover material %1</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salvar…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
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
        <translation>No trecho estreito</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>No canto dele</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>Flexionado no plano</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Flexionado através da chapa</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>Comprimido</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>Tracionado</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Cisalhado</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Torcido</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>Tão esbelto que pode flambar antes de quebrar.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Incerto: há forças agindo ao lado dos furos que ele atravessa.</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Um número aproximado: o trecho estreito é curto demais ou está perto demais de uma força.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Trincaria primeiro no canto.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Quebraria reto, de lado a lado.</translation>
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
        <translation>Tensão</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Fator de segurança %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistência desconhecida</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Nada acima de %1&#x202f;%</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>Movimento %1&#x202f;×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Não fica de pé; a tensão não é mostrada.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Um encaixe se abre; a tensão não é mostrada.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Não foi possível calcular se aguenta.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Procurando seções…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Fazendo facetas…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Planificando…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>Traçando %1…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>%n seção feita.</numerusform>
            <numerusform>%n seções feitas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Selecione primeiro a seção em que cortar furos ou coloque o desenho sobre ela.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Selecione primeiro a seção a gravar ou coloque o desenho sobre ela.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Procurando planos…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>Arquivo</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>ausente</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>lido a cada vez</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>guardado no modelo</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Localizar o arquivo…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Ler de onde o arquivo está agora; ela fica no mesmo lugar</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Vincular ao arquivo…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>Deixá-la fora do arquivo do modelo, que fica menor, e lê-la de onde está a cada vez</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>Guardá-la no modelo</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>Colocá-la no arquivo do modelo, para que esteja também em outros computadores</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>Mover, girar e redimensionar na vista, com alças ou números</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Por uma linha</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Traçar uma linha sobre algo nela cujo comprimento você conhece</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Mover e girar</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Referências</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Adicionar referência…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Ler uma malha, uma imagem ou um desenho para desenhar seções a partir dele</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Adicione uma malha, uma imagem ou um desenho, ou solte ou cole um aqui. As seções que você desenha aderem onde o plano delas corta uma malha e às linhas de um desenho no plano delas.</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 renomeia, Espaço oculta, L bloqueia, Del remove.</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Fatias…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>Cortá-la em seções que a acompanham</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Lugar e tamanho</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidade</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Dimensões</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconhecido</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Até o chão</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Apoiá-la no chão</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Pôr em pé</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Deitar do outro lado: o que é em cima nela fica em cima na vista</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 não encontrado</translation>
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
        <translation>Posição</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X do meio dela</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y do meio dela</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z do meio dela</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Girada em torno de X, primeiro</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Girada em torno de Y, depois de X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Girada em torno de Z, por último</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Malha, %n triângulo</numerusform>
            <numerusform>Malha, %n triângulos</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Imagem, %1 × %2 pixels</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Desenho, %n linha</numerusform>
            <numerusform>Desenho, %n linhas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Espessura</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Pular este passo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Encerrar o tour</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Tour, passo %1 de %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Olhe em volta.&lt;/b&gt; Arraste ao lado do modelo para girá-lo; use a roda para chegar mais perto.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Corte.&lt;/b&gt; &lt;b&gt;Exportar…&lt;/b&gt; mostra as chapas e grava o arquivo para a cortadora.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Desenhe um corpo.&lt;/b&gt; Pressione no meio da vista e desenhe o contorno em um só traço, plano em cima, até o chão.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Desenhe uma seção que o atravesse.&lt;/b&gt; Pressione dentro do corpo e arraste para fora pela borda. Mantenha o botão pressionado: a vista gira. Depois desenhe o contorno, de novo até o chão.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Meça sua chapa.&lt;/b&gt; Clique no material à direita da barra de ferramentas, depois na espessura, e digite o que você mediu: todas as fendas acompanham.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;Vai funcionar?&lt;/b&gt; Os selos sobre a vista dizem. Clique em um para ler mais.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Repita.&lt;/b&gt; Escolha &lt;b&gt;Fileira&lt;/b&gt;, clique na seção que atravessa o corpo e depois no corpo: as cópias ficam em fileira ao longo dele.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Esse foi o caminho todo,&lt;/b&gt; do primeiro traço ao arquivo. O que está vermelho tem links em Verificações que o corrigem. Pressione &lt;b&gt;F1&lt;/b&gt; para saber mais.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Quase.&lt;/b&gt; Arraste para trás a alça redonda no fim da fileira até nenhum selo estar vermelho; então &lt;b&gt;Exportar…&lt;/b&gt; grava o arquivo para a cortadora.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;Ficou muito pequeno.&lt;/b&gt; Desfaça e desenhe maior, com cerca de metade da largura da vista.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;O tour termina aqui.&lt;/b&gt; Você pode refazê-lo pelo menu &lt;b&gt;Ajuda&lt;/b&gt;. Pressione &lt;b&gt;F1&lt;/b&gt; para saber mais.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>Não é possível fazer cópia do trabalho não salvo para o caso de uma falha. Salve para não correr risco.</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Este trabalho foi aberto ou descartado em outra janela.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>Não foi possível abrir a cópia de segurança: %1.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sem título</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1, %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n passo</numerusform>
            <numerusform>%n passos</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Uma cópia de trabalho não salvo foi feita por um FlatFitFab mais novo; ela fica guardada como %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Uma cópia de trabalho não salvo não pôde ser lida; ela fica guardada como %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ângulo</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Número inteiro</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Proporção</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Sim ou não</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Opção</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>small</source>
        <translation>pequeno</translation>
    </message>
    <message>
        <source>large</source>
        <translation>grande</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Opções</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>pequeno | grande</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Feito de</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>título acima dele</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>para que serve</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Isto não pode ser lido como o que é preciso aqui.</translation>
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
        <translation>qualquer</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Outros podem ajustá-lo</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Pode ser definido onde o projeto é entregue para ajustes</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>O que é feito dele vira números simples</translation>
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
        <translation>Nome do valor</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Tipo, intervalo e nota</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Só para você</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>Ficou mais estreito o intervalo de: %1.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>A %n variante testada está boa.</numerusform>
            <numerusform>Todas as %n variantes testadas estão boas.</numerusform>
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
            <numerusform>%1 de %n variante falha: %2.</numerusform>
            <numerusform>%1 de %n variantes falham: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>De %1 cantos, %2 foram testados.</translation>
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
            <numerusform>e mais %n</numerusform>
            <numerusform>e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Testando os intervalos… %1 %</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Tentar de novo</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Testar todos os intervalos</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Estreitar os intervalos</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Diz onde, nos intervalos dos valores mostrados, o modelo não pode ser montado, quebra, tomba ou não cabe.</translation>
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
        <translation>Novo valor</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>valor</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Este projeto foi feito para ser ajustado: defina os valores e depois exporte. Arraste na vista para girá-lo.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>É cortado de %1.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>Não há nada para ajustar neste projeto.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Editar o projeto</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Entregar para ajustes</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Traz de volta o desenho e todos os painéis; se for salvo agora, o arquivo abre assim.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Quem abrir o modelo salvo verá a vista, os valores mostrados e Exportar, e nada mais.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Dê um nome a um número: qualquer campo pode usá-lo, também em contas como = 2*folga.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Como o modelo é mostrado</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Raio X</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Clique para ver de novo as seções como são.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Em corte</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Clique para ver de novo o modelo inteiro.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>TOPO</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>BASE</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>FRENTE</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>TRÁS</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>DIREITA</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>ESQUERDA</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>Vista do modelo</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Desenhe com o botão esquerdo do mouse, gire com o direito.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 para a oficina</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Os passos não estão entre os arquivos: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Onde pôr a pasta “%1”</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Pôr aqui</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>não dá para fazer imagens nesta tela.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Desenha peças planas em 3D e as corta.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modelos a abrir, cada um em uma janela; desenhos, malhas e imagens para adicionar a um novo.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Abre FILE como cópia: ao salvar, pede um nome.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Executa um roteiro de pressionar e mover.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>ROTEIRO</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Inicia sem o que estava configurado e não guarda configurações.</translation>
    </message>
</context>
</TS>
